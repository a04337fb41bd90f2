import { combine, hashPcg } from '../math/hash.ts';
import { cosTurns, sinTurns } from '../math/trig.ts';

const fade = (t: number): number => t * t * t * (t * (t * 6 - 15) + 10);

const DIRECTIONS = 32;
const GRADIENTS = Float64Array.from({ length: 2 * DIRECTIONS }, (_, i) =>
  i % 2 === 0 ? cosTurns(i / 2 / DIRECTIONS) : sinTurns((i - 1) / 2 / DIRECTIONS),
);

/** Gradient noise without end or repeat, about -0.7..0.7, 0 on the lattice of whole numbers (Perlin 2002). */
export function groundNoise(x: number, y: number, seed: number): number {
  const xi = Math.floor(x);
  const yi = Math.floor(y);
  const fx = x - xi;
  const fy = y - yi;
  const west = combine(seed, xi);
  const east = combine(seed, xi + 1);
  const corner = (column: number, row: number, dx: number, dy: number): number => {
    const g = 2 * (hashPcg((column + row) | 0) & (DIRECTIONS - 1));
    return GRADIENTS[g]! * dx + GRADIENTS[g + 1]! * dy;
  };
  const sx = fade(fx);
  const south = corner(west, yi, fx, fy);
  const north = corner(west, yi + 1, fx, fy - 1);
  const a = south + (corner(east, yi, fx - 1, fy) - south) * sx;
  const b = north + (corner(east, yi + 1, fx - 1, fy - 1) - north) * sx;
  return a + (b - a) * fade(fy);
}

/** Sines and cosines of a turn of the lattice for each octave: without it their hills would stand in rows. */
const TURN = 0.1031;

/** Octaves of ground noise, each half as long and `gain` as high as the last; about -1..1. */
export function octaveNoise(x: number, y: number, seed: number, octaves: number, gain: number): number {
  let sum = 0;
  let height = 1;
  let scale = 1;
  let whole = 0;
  for (let octave = 0; octave < octaves; octave++) {
    const c = cosTurns(octave * TURN) * scale;
    const s = sinTurns(octave * TURN) * scale;
    sum += height * groundNoise(c * x - s * y, s * x + c * y, combine(seed, octave));
    whole += height;
    height *= gain;
    scale *= 2;
  }
  return (1.6 * sum) / whole;
}
