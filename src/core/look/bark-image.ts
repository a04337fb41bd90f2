import { hashPcg, hashUnit } from '../math/hash.ts';
import type { BarkLook } from '../species/species.ts';
import { cellBorder, gradientField, gradientNoise, scatter } from './tiling-noise.ts';

/** A tile of bark, `size` x `size` texels of four bytes: dark 0..255 | slope around | slope along (128 is flat) | height. */
export interface BarkImage {
  readonly size: number;
  readonly data: Uint8Array<ArrayBuffer>;
}

/** Grains (`bark.grain`) that the tile holds along each side: large enough that the eye does not find the repeat. */
export const GRAINS_PER_TILE: Readonly<Record<BarkLook['kind'], number>> = {
  smooth: 3,
  furrowed: 6,
  plated: 6,
  peeling: 3,
  stringy: 6,
  palm: 4,
  ribbed: 4,
  noded: 4,
};

/** Height 0..1 and darkness 0..1 of each texel, rows run along the stem. */
interface Relief {
  readonly height: Float32Array;
  readonly dark: Float32Array;
}

const smoothstep = (a: number, b: number, x: number): number => {
  const t = Math.min(1, Math.max(0, (x - a) / (b - a)));
  return t * t * (3 - 2 * t);
};

/** Calls `paint` for every texel of an ellipse that wraps around the tile; d is 0 at its centre and 1 on its rim. */
function stamp(
  size: number,
  cx: number,
  cy: number,
  rx: number,
  ry: number,
  paint: (texel: number, d: number, dx: number, dy: number) => void,
): void {
  for (let y = Math.floor(cy - ry); y <= cy + ry; y++) {
    for (let x = Math.floor(cx - rx); x <= cx + rx; x++) {
      const dx = (x - cx) / rx;
      const dy = (y - cy) / ry;
      const d = dx * dx + dy * dy;
      if (d < 1) paint((((y % size) + size) % size) * size + (((x % size) + size) % size), Math.sqrt(d), dx, dy);
    }
  }
}

/** Pale, with dark lenticels (short dashes around the stem), knots where twigs were shed, and faint bands. */
function smooth(size: number): Relief {
  const height = new Float32Array(size * size);
  const dark = new Float32Array(size * size);
  const broad = gradientField(3, 5, 11);
  const bands = gradientField(2, 24, 12);
  const fine = gradientField(40, 64, 13);
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const u = x / size;
      const v = y / size;
      const a = gradientNoise(broad, 3, 5, u, v);
      const b = gradientNoise(bands, 2, 24, u, v + 0.02 * a);
      const c = gradientNoise(fine, 40, 64, u, v);
      height[y * size + x] = 0.6 + 0.1 * b + 0.03 * c;
      dark[y * size + x] = 0.1 + 0.2 * Math.max(0, a) + 0.13 * Math.max(0, b) + 0.1 * c;
    }
  }
  let h = 91;
  const draw = () => {
    h = hashPcg(h);
    return hashUnit(h);
  };
  for (let i = 0; i < 260; i++) {
    const long = draw() ** 3;
    const strength = 0.35 + 0.5 * draw();
    stamp(
      size,
      draw() * size,
      draw() * size,
      (0.006 + 0.03 * long) * size,
      (0.0022 + 0.002 * draw()) * size,
      (t, d) => {
        const f = strength * (1 - smoothstep(0.5, 1, d));
        dark[t] = Math.max(dark[t]!, f);
        height[t] = height[t]! + 0.22 * f;
      },
    );
  }
  for (let i = 0; i < 5; i++) {
    const rx = (0.03 + 0.03 * draw()) * size;
    const cx = draw() * size;
    const cy = ((i + 0.2 + 0.6 * draw()) / 5) * size;
    // The eye itself, ringed by swollen bark, and the drawn brow above it.
    stamp(size, cx, cy, rx * 1.9, rx * 1.2, (t, d) => {
      height[t] = height[t]! + 0.25 * smoothstep(1, 0.5, d) - 0.45 * smoothstep(0.5, 0.2, d);
      dark[t] = Math.max(dark[t]!, 0.95 * smoothstep(0.62, 0.4, d));
    });
    stamp(size, cx, cy + rx * 0.1, rx * 2.6, rx * 1.9, (t, d, dx, dy) => {
      const brow = smoothstep(0.14, 0.02, Math.abs(d - 0.82 + 0.25 * dx * dx)) * smoothstep(0.1, 0.45, dy);
      dark[t] = Math.max(dark[t]!, 0.6 * brow);
    });
  }
  return { height, dark };
}

/** Long ridges that part and meet again, with deep furrows between them. */
function furrowed(size: number): Relief {
  const height = new Float32Array(size * size);
  const dark = new Float32Array(size * size);
  const warp = gradientField(4, 3, 21);
  const ridge = gradientField(9, 3, 22);
  const second = gradientField(17, 6, 23);
  const cross = gradientField(14, 22, 24);
  const fine = gradientField(64, 40, 25);
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const u = x / size;
      const v = y / size;
      const w = 0.06 * gradientNoise(warp, 4, 3, u, v);
      const a = 1 - Math.min(1, Math.abs(gradientNoise(ridge, 9, 3, u + w, v)) * 3.6);
      const b = 1 - Math.min(1, Math.abs(gradientNoise(second, 17, 6, u + 1.4 * w, v)) * 3.2);
      const c = gradientNoise(cross, 14, 22, u + w, v);
      const f = gradientNoise(fine, 64, 40, u, v);
      const furrow = Math.max(smoothstep(0.35, 1, a), 0.62 * smoothstep(0.5, 1, b));
      height[y * size + x] = Math.max(0, 1 - furrow) * (0.85 + 0.15 * c) + 0.09 * f;
      dark[y * size + x] = Math.min(1, Math.max(0, 0.94 * furrow + 0.1 + 0.22 * c + 0.22 * f));
    }
  }
  return { height, dark };
}

/** Blocky plates, longer than wide, each a little domed and flaked, parted by dark cracks. */
function plated(size: number): Relief {
  const height = new Float32Array(size * size);
  const dark = new Float32Array(size * size);
  const [px, py] = [9, 5];
  const points = scatter(px, py, 31);
  const warpX = gradientField(13, 9, 32);
  const warpY = gradientField(11, 9, 33);
  const flake = gradientField(26, 40, 34);
  const fine = gradientField(80, 64, 35);
  const found = { edge: 0, cell: 0 };
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const u = x / size;
      const v = y / size;
      const wx = 0.035 * gradientNoise(warpX, 13, 9, u, v);
      const wy = 0.05 * gradientNoise(warpY, 11, 9, u, v);
      cellBorder(points, px, py, u + wx, v + wy, found);
      const f = gradientNoise(fine, 80, 64, u, v);
      const g = gradientNoise(flake, 26, 40, u + wx, v);
      const plate = smoothstep(0.05, 0.34, found.edge + 0.16 * g);
      const own = hashUnit(hashPcg(found.cell + 77));
      height[y * size + x] = plate * (0.72 + 0.2 * own + 0.14 * g) + 0.08 * f;
      dark[y * size + x] = Math.min(1, Math.max(0, 0.96 * (1 - plate) + 0.26 * own - 0.08 + 0.3 * g + 0.2 * f));
    }
  }
  return { height, dark };
}

const RELIEFS: Readonly<Record<BarkLook['kind'], (size: number) => Relief>> = {
  smooth,
  furrowed,
  plated,
  peeling: smooth,
  stringy: furrowed,
  palm: plated,
  ribbed: smooth,
  noded: smooth,
};

/**
 * A tile of bark of the given kind, the same on every machine; `size` texels a side, a power of two.
 *
 * Slopes are those of a relief one tile wide and a fifteenth of a tile deep; the shader scales them.
 */
export function barkImage(kind: BarkLook['kind'], size: number): BarkImage {
  const { height, dark } = RELIEFS[kind](size);
  const data = new Uint8Array(size * size * 4);
  const mask = size - 1;
  const depth = size / 15 / 2; // central difference over two texels, in texels of height
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const i = y * size + x;
      const sx = (height[y * size + ((x + 1) & mask)]! - height[y * size + ((x - 1) & mask)]!) * depth;
      const sy = (height[((y + 1) & mask) * size + x]! - height[((y - 1) & mask) * size + x]!) * depth;
      data[i * 4] = Math.round(255 * Math.min(1, Math.max(0, dark[i]!)));
      // Slopes to -1..1 by s / (1 + |s|), so that steep walls keep their direction in eight bits.
      data[i * 4 + 1] = Math.round(127.5 + 127.5 * (sx / (1 + Math.abs(sx))));
      data[i * 4 + 2] = Math.round(127.5 + 127.5 * (sy / (1 + Math.abs(sy))));
      data[i * 4 + 3] = Math.round(255 * Math.min(1, Math.max(0, height[i]!)));
    }
  }
  return { size, data };
}
