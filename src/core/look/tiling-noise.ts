import { hashPcg, hashUnit } from '../math/hash.ts';
import { cosTurns, sinTurns } from '../math/trig.ts';

/** Noise that repeats after whole cells, for textures that tile. */

const lattice = (x: number, y: number, seed: number): number => hashPcg((hashPcg((x + seed * 7919) | 0) + y) | 0);

/** Warps lead a cell or two outside: steps are cheaper than a division, and this is called some ten million times a tile. */
function wrap(i: number, period: number): number {
  let at = i;
  while (at < 0) at += period;
  while (at >= period) at -= period;
  return at;
}

const fade = (t: number): number => t * t * t * (t * (t * 6 - 15) + 10);

const GRADIENTS: readonly (readonly [number, number])[] = Array.from({ length: 16 }, (_, i) => [
  cosTurns(i / 16),
  sinTurns(i / 16),
]);

/** Gradients of a lattice of `px` x `py` cells: made once, read four times a sample. */
export function gradientField(px: number, py: number, seed: number): Float32Array {
  const field = new Float32Array(px * py * 2);
  for (let y = 0; y < py; y++) {
    for (let x = 0; x < px; x++) {
      const g = GRADIENTS[lattice(x, y, seed) & 15] as readonly [number, number];
      field.set(g, (y * px + x) * 2);
    }
  }
  return field;
}

/** Gradient noise at (u, v) in 0..1 over the field's cells, about -0.7..0.7. */
export function gradientNoise(field: Float32Array, px: number, py: number, u: number, v: number): number {
  const x = u * px;
  const y = v * py;
  const xi = Math.floor(x);
  const yi = Math.floor(y);
  const fx = x - xi;
  const fy = y - yi;
  const x0 = wrap(xi, px);
  const x1 = x0 + 1 === px ? 0 : x0 + 1;
  const row0 = wrap(yi, py) * px;
  const row1 = (row0 / px + 1 === py ? 0 : row0 / px + 1) * px;
  const a = (row0 + x0) * 2;
  const b = (row0 + x1) * 2;
  const c = (row1 + x0) * 2;
  const d = (row1 + x1) * 2;
  const n00 = field[a]! * fx + field[a + 1]! * fy;
  const n10 = field[b]! * (fx - 1) + field[b + 1]! * fy;
  const n01 = field[c]! * fx + field[c + 1]! * (fy - 1);
  const n11 = field[d]! * (fx - 1) + field[d + 1]! * (fy - 1);
  const sx = fade(fx);
  const top = n00 + (n10 - n00) * sx;
  return top + (n01 + (n11 - n01) * sx - top) * fade(fy);
}

/** One point in each of `px` x `py` cells: x | y in cells; 2 a cell. */
export function scatter(px: number, py: number, seed: number): Float32Array {
  const points = new Float32Array(px * py * 2);
  for (let y = 0; y < py; y++) {
    for (let x = 0; x < px; x++) {
      const h = lattice(x, y, seed);
      points[(y * px + x) * 2] = x + 0.12 + 0.76 * hashUnit(h);
      points[(y * px + x) * 2 + 1] = y + 0.12 + 0.76 * hashUnit(hashPcg(h));
    }
  }
  return points;
}

/**
 * How far (u, v) is from the border between the two nearest points of a scatter, the number of the nearest and how far that is; distances in
 * cells.
 */
export function cellBorder(
  points: Float32Array,
  px: number,
  py: number,
  u: number,
  v: number,
  out: { edge: number; cell: number; near: number },
): void {
  const x = u * px;
  const y = v * py;
  const xi = Math.floor(x);
  const yi = Math.floor(y);
  let near = 1e9;
  let next = 1e9;
  for (let dy = -1; dy <= 1; dy++) {
    const cy = yi + dy;
    const wy = wrap(cy, py);
    for (let dx = -1; dx <= 1; dx++) {
      const cx = xi + dx;
      const cell = wy * px + wrap(cx, px);
      const ex = points[cell * 2]! + (cx - wrap(cx, px)) - x;
      const ey = points[cell * 2 + 1]! + (cy - wy) - y;
      const d = ex * ex + ey * ey;
      if (d < near) {
        next = near;
        near = d;
        out.cell = cell;
      } else if (d < next) next = d;
    }
  }
  out.near = Math.sqrt(near);
  out.edge = Math.sqrt(next) - out.near;
}
