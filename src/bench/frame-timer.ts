import type { WebGLRenderer } from 'three';
import { interleave, type Subject, type Timing } from '../gpu/interleave.ts';

/** A frame to time; `draw` moves and draws. */
export interface Frame {
  readonly name: string;
  draw(n: number): void;
}

/** What a frame drew, shadows and wind pass with it. */
export interface Drawn {
  readonly triangles: number;
  readonly calls: number;
}

/** Times frames in turn, each waited for; what each drew beside it. */
export function timeFrames(
  renderer: WebGLRenderer,
  frames: readonly Frame[],
  rounds: number,
  milliseconds: number,
): readonly (Timing & Drawn)[] {
  const gl = renderer.getContext();
  const texel = new Uint8Array(4);
  const drawn = frames.map((): Drawn => ({ triangles: 0, calls: 0 }));
  let n = 0;
  renderer.info.autoReset = false;
  const subjects = frames.map(
    (frame, i): Subject => ({
      name: frame.name,
      run: () => {
        renderer.info.reset();
        frame.draw(++n);
        drawn[i] = { ...renderer.info.render };
        // Frames must not pile up.
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, texel);
      },
      wait: () => {},
    }),
  );
  const timings = interleave(subjects, rounds, milliseconds);
  renderer.info.autoReset = true;
  return timings.map((timing, i) => ({ ...timing, ...(drawn[i] as Drawn) }));
}

/** The picture of the frame that `draw` makes: RGBA, bottom row first. */
export function pixelsOf(renderer: WebGLRenderer, draw: () => void): Uint8Array {
  draw();
  const gl = renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const out = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, out);
  return out;
}

/**
 * How far two pictures are apart, percent of white: root mean square over the pixels that either of them has changed of the `empty` one, so that sky
 * beside a tree does not make it look better.
 */
export function difference(a: Uint8Array, b: Uint8Array, empty: Uint8Array): number {
  let sum = 0;
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    let changed = false;
    let square = 0;
    for (let k = i; k < i + 3; k++) {
      changed ||= Math.abs(a[k]! - empty[k]!) > 2 || Math.abs(b[k]! - empty[k]!) > 2;
      square += (a[k]! - b[k]!) ** 2;
    }
    if (!changed) continue;
    sum += square / 3;
    count++;
  }
  return count > 0 ? (100 * Math.sqrt(sum / count)) / 255 : 0;
}
