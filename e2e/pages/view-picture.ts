import { growPacked } from '../../src/core/pack/grow-packed.ts';
import { DEFAULT_WAVE, STILL, type Wind } from '../../src/core/wind/wind.ts';
import { CaptureStage } from '../../src/view/picture/capture-stage.ts';
import { LivePicture } from '../../src/view/picture/live-picture.ts';
import type { Overlays } from '../../src/view/picture/picture.ts';
import { WindTree } from '../../src/view/wind-tree.ts';
import { grown, small } from './grown.ts';

// The editor's picture by itself, for e2e/view.spec.ts: what it shows beside the tree, and what hands do to it.
const host = document.querySelector('#host') as HTMLElement;
const told: unknown[] = [];
const note =
  (name: string) =>
  (...words: unknown[]): void => {
    told.push([name, ...words]);
  };
const picture = new LivePicture(host, {
  onChange: () => {},
  onCamera: note('camera'),
  onLost: note('lost'),
  onHandle: note('handle'),
  onHoverStem: note('hover'),
  onPickStem: note('stem'),
  onStemHandle: note('stem handle'),
  onThrow: note('throw'),
  onWipe: note('wipe'),
});
const wind = (amplitude: number): Wind => ({ ...STILL, waves: [{ ...DEFAULT_WAVE, amplitude, wavelength: 12 }] });
const { packed, species, stems, stats } = await grown('quaking-aspen', 1, small);
const tree = { packed, stems, stats, milliseconds: { grow: 0, fit: 0, pack: 0 } };
picture.setTree(tree, species);
picture.setWind(wind(0.15), 0);
picture.setCamera({ azimuth: 20, elevation: 16, distance: 34, target: [0, 5, 0] });

const NONE: Overlays = { arrows: false, fronts: false, handle: false, probe: null, highlight: null };

/** The pixels as they are drawn at a time, row by row from the top. */
function draw(time: number): Uint8Array {
  picture.draw(time, false);
  const gl = picture.renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const rows = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rows);
  const out = new Uint8Array(rows.length);
  for (let y = 0; y < height; y++)
    out.set(rows.subarray(y * width * 4, (y + 1) * width * 4), (height - 1 - y) * width * 4);
  return out;
}

/** Part of the pixels of columns from..to (of 480) that differ. */
function changed(a: Uint8Array, b: Uint8Array, from = 0, to = 480): number {
  let n = 0;
  for (let y = 0; y < 360; y++) {
    for (let x = from; x < to; x++) {
      const i = (y * 480 + x) * 4;
      if (a[i] !== b[i] || a[i + 1] !== b[i + 1] || a[i + 2] !== b[i + 2]) n++;
    }
  }
  return n / ((to - from) * 360);
}

/** Part of the pixels that differ by more than smoothing does. */
function far(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let n = 0;
  for (let i = 0; i < a.length; i += 4) {
    const away = [0, 1, 2].map((k) => Math.abs((a[i + k] as number) - (b[i + k] as number)));
    if (Math.max(...away) > 40) n++;
  }
  return n / (a.length / 4);
}

const pixelsOf = (canvas: HTMLCanvasElement | OffscreenCanvas): Uint8Array =>
  new Uint8Array((canvas as HTMLCanvasElement).getContext('2d')?.getImageData(0, 0, 480, 360).data.buffer ?? []);

const scene = {
  told,

  /** Parts of the picture that each overlay changes, and that are left of it when it goes; and whether arrows move with time. */
  overlays() {
    const plain = draw(1);
    const part = (overlays: Partial<Overlays>): number => {
      picture.setOverlays({ ...NONE, ...overlays });
      const part = changed(plain, draw(1));
      picture.setOverlays(NONE);
      return part;
    };
    const gust = {
      start: 1,
      x: 0,
      y: 0,
      direction: 1,
      speed: 8,
      amplitude: 0.2,
      rise: 0.5,
      fall: 1,
      width: 10,
      repeat: 0,
    };
    const result = {
      arrows: part({ arrows: true }),
      handle: part({ handle: true }),
      probe: part({ probe: 20 }),
      highlight: part({ highlight: 3 }),
      fronts: part({ fronts: true }),
      none: changed(plain, draw(1)),
    };
    picture.setWind({ ...wind(0.15), gusts: [gust] }, 0);
    const gusty = draw(1);
    picture.setOverlays({ ...NONE, fronts: true });
    const front = changed(gusty, draw(1));
    picture.setOverlays(NONE);
    picture.setWind(wind(0.15), 0);
    return { ...result, front };
  },

  /** How green (above red and blue) the picture is around the end of a piece that the probe sticks to, and without it. */
  probe() {
    const piece = 20;
    const at = (): number => {
      const pixels = draw(2);
      const { branches } = picture.onScreen();
      const x = Math.round((branches[(piece * 9 + 8) * 2] as number) - 40);
      const y = Math.round((branches[(piece * 9 + 8) * 2 + 1] as number) - 20);
      let sum = 0;
      for (let k = 0; k < 16; k++) {
        const u = x + Math.round(8.4 * Math.cos((k * Math.PI) / 8));
        const v = y + Math.round(8.4 * Math.sin((k * Math.PI) / 8));
        const i = (v * 480 + u) * 4;
        // The answer's green, #1a7f37.
        sum += Math.hypot(
          (pixels[i] as number) - 0x1a,
          (pixels[i + 1] as number) - 0x7f,
          (pixels[i + 2] as number) - 0x37,
        );
      }
      return sum / 16;
    };
    const without = at();
    picture.setOverlays({ ...NONE, probe: piece });
    const near = at();
    picture.setOverlays(NONE);
    return { near, without };
  },

  /** A and B in one picture against each alone: parts that differ left and right of the line. */
  split() {
    const alone = [0.15, 0.5].map((amplitude) => {
      picture.setWind(wind(amplitude), 0);
      return draw(1);
    });
    picture.setWind(wind(0.15), 0);
    picture.setCompare({ wind: wind(0.5), layout: 'split', at: 0.5 }, 0);
    draw(1);
    const both = draw(1); // nothing moved, and yet each side needs its own shadows
    const calls = picture.draw(1, false).drawCalls;
    picture.setCompare({ wind: wind(0.5), layout: 'side', at: 0.5 }, 0);
    const side = draw(1);
    picture.setCompare(null, 0);
    const again = draw(1);
    const [a, b] = alone as [Uint8Array, Uint8Array];
    return {
      apart: changed(a, b, 245, 480),
      left: changed(both, a, 0, 235),
      right: changed(both, b, 245, 480),
      side: changed(side, a),
      again: changed(again, a),
      calls: calls / picture.draw(1, false).drawCalls,
    };
  },

  /** Shows the handle or the line for the test's mouse, and tells where it is in the window. */
  handle() {
    picture.setOverlays({ ...NONE, handle: true });
    draw(1);
    return picture.camera;
  },

  line() {
    picture.setOverlays(NONE);
    picture.setCompare({ wind: wind(0.5), layout: 'split', at: 0.3 }, 0);
    draw(1);
    return picture.camera;
  },

  /** Points in the window: of the trunk, and of the meadow before the tree. */
  points() {
    picture.setCompare(null, 0);
    picture.setOverlays(NONE);
    draw(1);
    const { branches } = picture.onScreen();
    return { trunk: [branches[4], branches[5]], camera: picture.camera };
  },

  /** Points of the window over which the pointer is this cursor: the middle of the leftmost of them, and how high they reach there. */
  find(cursor: string): { x: number; y: number; height: number } {
    const canvas = picture.canvas;
    const over = (x: number, y: number): boolean => {
      canvas.dispatchEvent(new PointerEvent('pointermove', { clientX: x, clientY: y, pointerType: 'mouse' }));
      return canvas.style.cursor === cursor;
    };
    for (let x = 42; x < 520; x += 2) {
      const rows: number[] = [];
      for (let y = 22; y < 380; y += 2) if (over(x + 12, y)) rows.push(y);
      const [first, last] = [rows[0], rows.at(-1)];
      if (rows.length > 4 && first && last) return { x: x + 12, y: (first + last) / 2, height: last - first };
    }
    return { x: 0, y: 0, height: 0 };
  },

  pick: (x: number, y: number) => picture.pickPiece(x, y),
  ground: (x: number, y: number) => picture.pickGround(x, y),

  /** Captures against the picture on the screen and each other, as parts of the pixels that differ; and a portrait. */
  async captures() {
    picture.setOverlays(NONE);
    const size = { width: 480, height: 360 };
    const shown = draw(1);
    const capture = await picture.openCapture({ ...size, transparent: false });
    await capture.draw(1);
    const first = pixelsOf(capture.canvas);
    await capture.draw(2.5);
    const later = pixelsOf(capture.canvas);
    await capture.draw(1);
    const again = pixelsOf(capture.canvas);
    capture.close();
    const closed = await capture.draw(1).then(
      () => '',
      (error: Error) => error.message,
    );
    const clear = await picture.openCapture({ ...size, transparent: true });
    await clear.draw(1);
    const alone = pixelsOf(clear.canvas);
    clear.close();
    const alpha = (x: number, y: number): number => alone[4 * (480 * y + x) + 3] as number;
    let covered = 0;
    for (let i = 3; i < alone.length; i += 4) covered += (alone[i] as number) > 127 ? 1 : 0;
    const tiles = new CaptureStage('stage', new WindTree(), 150);
    const canvas = Object.assign(document.createElement('canvas'), size);
    const show = { levelsShown: Number.POSITIVE_INFINITY, showLeaves: true, view: 'shaded' } as const;
    tiles.take({ packed, stems, species, wind: wind(0.15), show, dark: false, channel: null });
    await tiles.draw(canvas, 1, { pose: picture.camera, high: 1, wide: 480 / 360 });
    const tiled = pixelsOf(canvas);
    tiles.dispose();
    const blob = await picture.portrait(tree, species, { width: 120, height: 150 });
    const image = await createImageBitmap(blob);
    const context = new OffscreenCanvas(120, 150).getContext('2d') as OffscreenCanvasRenderingContext2D;
    context.drawImage(image, 0, 0);
    const portrait = new Uint32Array(context.getImageData(0, 0, 120, 150).data.buffer);
    return {
      same: far(shown, first),
      apart: far(first, later),
      again: changed(first, again),
      undisturbed: changed(shown, draw(1)),
      corners: [alpha(0, 0), alpha(479, 0), alpha(0, 359), alpha(479, 359)],
      tree: covered / (480 * 360),
      tiled: far(first, tiled),
      portrait: { colours: new Set(portrait).size, size: [image.width, image.height] },
      closed,
    };
  },

  /** What WebGL holds before and after a hundred trees, and how many draws trees take to a far time: set whole, as a draft, and whole again. */
  async trees() {
    const gl = picture.renderer.getContext();
    const others = [2, 3].map((seed) => {
      const { packed, stems, stats } = growPacked(species, seed);
      return { packed, stems, stats, milliseconds: tree.milliseconds };
    });
    picture.setWind(wind(0.15), 0);
    const held = new Map<string, number>();
    for (const kind of ['Texture', 'Buffer', 'Framebuffer', 'Program', 'VertexArray'] as const) {
      const [make, drop] = [`create${kind}`, `delete${kind}`] as const;
      const context = gl as unknown as Record<string, (...words: unknown[]) => unknown>;
      const made = context[make]?.bind(gl);
      const dropped = context[drop]?.bind(gl);
      held.set(kind, 0);
      context[make] = (...words) => {
        held.set(kind, (held.get(kind) ?? 0) + 1);
        return made?.(...words);
      };
      context[drop] = (...words) => {
        if (words[0]) held.set(kind, (held.get(kind) ?? 0) - 1);
        return dropped?.(...words);
      };
    }
    const cycle = (rounds: number): Record<string, number> => {
      for (let i = 0; i < rounds; i++) {
        picture.setTree(i % 3 === 2 ? tree : (others[i % 3] as typeof tree), species, { draft: i % 3 === 0 });
        picture.draw(0.1 + (i % 3) / 60, true);
      }
      return Object.fromEntries(held);
    };
    const before = cycle(9);
    const after = cycle(90);
    const drawsTo = (time: number): number => {
      let draws = 1;
      while (picture.draw(time, false).catchingUp !== null) draws++;
      return draws;
    };
    picture.setTree(tree, species);
    const far = drawsTo(60);
    const whole = draw(60);
    const [other] = others as [typeof tree];
    picture.setTree(other, species, { draft: true });
    const near = drawsTo(60);
    picture.setTree(other, species);
    const pure = drawsTo(60);
    picture.setTree(tree, species);
    drawsTo(60);
    const again = changed(whole, draw(60));
    return { before, after, far, near, pure, again };
  },

  /** The state textures and one piece, read back. */
  async read() {
    draw(1);
    const [images, piece, none] = await Promise.all([
      picture.readTextures(),
      picture.readPiece(7),
      picture.readPiece(1e6),
    ]);
    const { width, height, pieceCount, layers } = images;
    const texel = layers.slice(0, 4).flatMap(({ data }) => [...data.subarray(28, 32)]);
    return {
      size: width * height * 4,
      pieceCount,
      layers: layers.map(({ id, data }) => [id, data.length]),
      texel,
      piece: [...(piece ?? [])],
      none,
    };
  },
};

Object.assign(window, { scene });
declare global {
  interface Window {
    scene: typeof scene;
  }
}
