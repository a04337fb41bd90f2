import type { ClearingsDensity, ForestDocument } from './forest.ts';
import type { GreyMap } from './grey-map.ts';
import { octaveNoise } from './ground-noise.ts';

/** How full of trees the ground is, over a square that is centred on 0, 0. */
export interface DensityField {
  /** Metres of a side. */
  readonly size: number;
  /** Samples of a side, at least 2; the outermost lie on the edges. */
  readonly side: number;
  /** 0 bare .. 1 full; side x side, x fastest, from -x, -y. */
  readonly values: Float32Array;
}

const CELL = 2.5;
const SIDES = [65, 513] as const;

/** Of the noise: how far above the threshold the forest is full. */
const EDGE = 0.07;

/** Full everywhere. */
export const fullDensity = (size: number): DensityField => ({ size, side: 2, values: new Float32Array(4).fill(1) });

/** Clearings that take exactly the part of the ground that is asked for, with a wood's edge of thinner trees around. */
export function clearingsField({ seed, bare, scale }: ClearingsDensity, size: number): DensityField {
  if (bare === 0) return fullDensity(size);
  const side = Math.min(SIDES[1], Math.max(SIDES[0], Math.ceil(size / CELL) + 1));
  const values = new Float32Array(side * side);
  const cell = size / (side - 1);
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      values[j * side + i] = octaveNoise((i * cell - size / 2) / scale, (j * cell - size / 2) / scale, seed, 3, 0.4);
    }
  }
  const sorted = values.slice().sort();
  const threshold = sorted[Math.min(sorted.length - 1, Math.round(bare * sorted.length))]!;
  for (let k = 0; k < values.length; k++) values[k] = Math.min(1, Math.max(0, (values[k]! - threshold) / EDGE));
  return { size, side, values };
}

/** 0..1 at a place; beyond the edges as at the edge. */
export function densityAt({ size, side, values }: DensityField, x: number, y: number): number {
  const last = side - 1;
  const u = Math.min(last, Math.max(0, (x / size + 0.5) * last));
  const v = Math.min(last, Math.max(0, (y / size + 0.5) * last));
  const i = Math.min(last - 1, Math.floor(u));
  const j = Math.min(last - 1, Math.floor(v));
  const at = j * side + i;
  const south = values[at]! + (values[at + 1]! - values[at]!) * (u - i);
  const north = values[at + side]! + (values[at + side + 1]! - values[at + side]!) * (u - i);
  return south + (north - south) * (v - j);
}

/** The density of a forest. `map` is the picture that it asks for, null where there is none at hand: then it is full everywhere. */
export function forestDensity(
  { density, size }: Pick<ForestDocument, 'density' | 'size'>,
  map: GreyMap | null,
): DensityField {
  if (density.kind === 'clearings') return clearingsField(density, size);
  return map ? { size, side: map.side, values: map.values } : fullDensity(size);
}
