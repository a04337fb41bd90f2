import type { Frame } from './frame.ts';
import { widened } from './stem-builder.ts';
import type { Leaves } from './tree.ts';

/** Leaves while they are grown: the arrays of `Leaves`, with room to grow. */
export class LeafBuilder {
  count = 0;
  private stem = new Int32Array(4096);
  private z = new Float32Array(4096);
  private orientation = new Float32Array(4 * 4096);
  private phase = new Float32Array(4096);

  add(stem: number, z: number, f: Frame, phase: number): void {
    const i = this.count;
    if (i === this.stem.length) this.reserve(i + 1);
    this.stem[i] = stem;
    this.z[i] = z;
    this.phase[i] = phase;
    writeQuaternion(f, this.orientation, 4 * i);
    this.count = i + 1;
  }

  /** The arrays at their exact size; every blade is `length` metres long. */
  finish(length: number): Leaves {
    const n = this.count;
    return {
      count: n,
      stem: this.stem.slice(0, n),
      z: this.z.slice(0, n),
      orientation: this.orientation.slice(0, 4 * n),
      length: new Float32Array(n).fill(length),
      phase: this.phase.slice(0, n),
    };
  }

  /** Makes room for so many leaves in one go. */
  reserve(needed: number): void {
    if (needed <= this.stem.length) return;
    this.stem = widened(this.stem, needed);
    this.z = widened(this.z, needed);
    this.orientation = widened(this.orientation, 4 * needed);
    this.phase = widened(this.phase, needed);
  }
}

/** The rotation of a frame as a quaternion (x, y, z, w) with w >= 0, without allocating: `quaternionFromMatrix` for hot loops. */
export function writeQuaternion(f: Frame, out: Float32Array, offset: number): void {
  const a = f[0];
  const e = f[4];
  const i = f[8];
  let x: number;
  let y: number;
  let z: number;
  let w: number;
  if (a + e + i > 0) {
    w = 1 + a + e + i;
    x = f[5] - f[7];
    y = f[6] - f[2];
    z = f[1] - f[3];
  } else if (a >= e && a >= i) {
    x = 1 + a - e - i;
    y = f[3] + f[1];
    z = f[6] + f[2];
    w = f[5] - f[7];
  } else if (e >= i) {
    y = 1 + e - a - i;
    x = f[3] + f[1];
    z = f[7] + f[5];
    w = f[6] - f[2];
  } else {
    z = 1 + i - a - e;
    x = f[6] + f[2];
    y = f[7] + f[5];
    w = f[1] - f[3];
  }
  const n = (w < 0 ? -1 : 1) / Math.sqrt(x * x + y * y + z * z + w * w);
  out[offset] = x * n;
  out[offset + 1] = y * n;
  out[offset + 2] = z * n;
  out[offset + 3] = w * n;
}
