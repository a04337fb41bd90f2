import { hashPcg, hashUnit } from '../math/hash.ts';
import { cellBorder, gradientField, gradientNoise, scatter } from './tiling-noise.ts';

/** A tile of bark in the making: height 0..1 and darkness 0..1 of each texel, rows run along the stem. */
export interface Relief {
  readonly height: Float32Array;
  readonly dark: Float32Array;
}

/** What a texel is given; `paint` writes it. */
export interface Dab {
  height: number;
  dark: number;
}

/** 0 below a, 1 above b, smooth between; a > b turns it round. */
export const smoothstep = (a: number, b: number, x: number): number => {
  const t = Math.min(1, Math.max(0, (x - a) / (b - a)));
  return t * t * (3 - 2 * t);
};

export const mix = (a: number, b: number, t: number): number => a + (b - a) * t;

/** A noise of `px` x `py` cells that repeats after the tile, about -0.7..0.7 at (u, v) in tiles. */
export function noise(px: number, py: number, seed: number): (u: number, v: number) => number {
  const field = gradientField(px, py, seed);
  return (u, v) => gradientNoise(field, px, py, u, v);
}

/** `octaves` noises, each twice as fine and half as strong as the one before; about -0.8..0.8. */
export function cloud(px: number, py: number, seed: number, octaves: number): (u: number, v: number) => number {
  const parts = Array.from({ length: octaves }, (_, i) => noise(px << i, py << i, seed + 101 * i));
  return (u, v) => {
    let sum = 0;
    let share = 1;
    for (const part of parts) {
      sum += share * part(u, v);
      share *= 0.5;
    }
    return sum;
  };
}

/** Random numbers in [0, 1), the same in every engine. */
export function drawer(seed: number): () => number {
  let h = hashPcg(seed);
  return () => {
    h = hashPcg(h);
    return hashUnit(h);
  };
}

/** A tile whose every texel is painted by `at`, at the texel's place in tiles. */
export function paint(size: number, at: (u: number, v: number, out: Dab, texel: number) => void): Relief {
  const height = new Float32Array(size * size);
  const dark = new Float32Array(size * size);
  const dab: Dab = { height: 0, dark: 0 };
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      at(x / size, y / size, dab, y * size + x);
      height[y * size + x] = dab.height;
      dark[y * size + x] = dab.dark;
    }
  }
  return { height, dark };
}

/**
 * Calls `touch` for every texel of an ellipse that wraps around the tile: its index, its distance d (0 at the centre, 1 on the rim) and its
 * place (dx, dy) in radii. Centre and radii are in tiles.
 */
export function stamp(
  size: number,
  [cu, cv]: readonly [number, number],
  [ru, rv]: readonly [number, number],
  touch: (texel: number, d: number, dx: number, dy: number) => void,
): void {
  const [cx, cy, rx, ry] = [cu * size, cv * size, ru * size, rv * size];
  const mask = size - 1;
  for (let y = Math.ceil(cy - ry); y <= cy + ry; y++) {
    for (let x = Math.ceil(cx - rx); x <= cx + rx; x++) {
      const dx = (x - cx) / rx;
      const dy = (y - cy) / ry;
      const d = dx * dx + dy * dy;
      if (d < 1) touch((y & mask) * size + (x & mask), Math.sqrt(d), dx, dy);
    }
  }
}

/** Cells of a scatter as a map: which a texel is in, how far from its border in tiles, and how far the border there runs around the stem. */
export interface CellMap {
  readonly cell: Uint16Array;
  readonly distance: Float32Array;
  /** 0 where the border runs along the stem, 1 where it runs around it. */
  readonly around: Float32Array;
}

/** How far each texel is moved, 2 a texel, asked for at every other one alone: what moves is smooth, and dear. */
function warps(size: number, warp: (u: number, v: number, out: { u: number; v: number }) => void): Float32Array {
  const out = new Float32Array(2 * size * size);
  const by = { u: 0, v: 0 };
  for (let y = 0; y < size; y += 2) {
    for (let x = 0; x < size; x += 2) {
      warp(x / size, y / size, by);
      out[2 * (y * size + x)] = by.u;
      out[2 * (y * size + x) + 1] = by.v;
    }
  }
  const between = (t: number, a: number, b: number) => {
    out[2 * t] = (out[2 * a]! + out[2 * b]!) / 2;
    out[2 * t + 1] = (out[2 * a + 1]! + out[2 * b + 1]!) / 2;
  };
  for (let y = 0; y < size; y += 2) {
    for (let x = 1; x < size; x += 2) between(y * size + x, y * size + x - 1, y * size + ((x + 1) % size));
  }
  for (let y = 1; y < size; y += 2) {
    for (let x = 0; x < size; x++) between(y * size + x, (y - 1) * size + x, ((y + 1) % size) * size + x);
  }
  return out;
}

/**
 * The cells of `px` x `py` points, each texel's place moved by `warp` (tiles) before it is asked for. Distances are true ones whatever the cells'
 * proportions, so that cracks are as wide one way as the other.
 */
export function cellMap(
  size: number,
  [px, py]: readonly [number, number],
  seed: number,
  warp: (u: number, v: number, out: { u: number; v: number }) => void,
): CellMap {
  const points = scatter(px, py, seed);
  const edge = new Float32Array(size * size);
  const cell = new Uint16Array(size * size);
  const distance = new Float32Array(size * size);
  const around = new Float32Array(size * size);
  const found = { edge: 0, cell: 0, near: 0 };
  const moved = warps(size, warp);
  for (let y = 0, t = 0; y < size; y++) {
    for (let x = 0; x < size; x++, t++) {
      cellBorder(points, px, py, x / size + moved[2 * t]!, y / size + moved[2 * t + 1]!, found);
      edge[t] = found.edge;
      cell[t] = found.cell;
    }
  }
  const mask = size - 1;
  for (let y = 0, t = 0; y < size; y++) {
    const above = ((y + 1) & mask) * size;
    const below = ((y - 1) & mask) * size;
    for (let x = 0; x < size; x++, t++) {
      const dx = (edge[y * size + ((x + 1) & mask)]! - edge[y * size + ((x - 1) & mask)]!) * 0.5 * size;
      const dy = (edge[above + x]! - edge[below + x]!) * 0.5 * size;
      const square = dx * dx + dy * dy;
      // On a crest the slope vanishes: nothing is as far as that.
      distance[t] = edge[t]! / Math.max(Math.sqrt(square), Math.min(px, py));
      around[t] = (dy * dy) / Math.max(square, 1e-6);
    }
  }
  return { cell, distance, around };
}
