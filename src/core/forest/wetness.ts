import type { HeightField } from './height-field.ts';

/** How wet the ground is, sampled as the heights are: 0 on a dry ridge, 0.5 on an even slope, 1 in a hollow. */
export interface WetnessField {
  readonly size: number;
  readonly side: number;
  readonly values: Float32Array;
}

/** Metres around a place whose mean height it is held against, as a part of the side of the field. */
const AROUND = 0.09;

/** Deviations from the mean at which the ground is as wet, or as dry, as any. */
const DEVIATIONS = 1.6;

/** Metres: ground that differs less is even. */
const EVEN = 0.4;

/** Water runs to where the ground is below what lies around it: wetness by height below the local mean. */
export function wetnessField({ size, side, heights }: HeightField): WetnessField {
  const reach = Math.max(1, Math.round(AROUND * (side - 1)));
  const sums = summed(heights, side);
  const below = new Float32Array(side * side);
  let squares = 0;
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      // Near an edge the window shrinks to both sides alike, or every slope would be wet at its foot and dry at its top.
      const r = Math.max(0, Math.min(reach, i, j, side - 1 - i, side - 1 - j));
      const at = j * side + i;
      below[at] = mean(sums, side, i - r, j - r, i + r, j + r) - heights[at]!;
      squares += below[at]! * below[at]!;
    }
  }
  const whole = DEVIATIONS * Math.max(EVEN, Math.sqrt(squares / below.length));
  for (let k = 0; k < below.length; k++) below[k] = 0.5 + 0.5 * Math.min(1, Math.max(-1, below[k]! / whole));
  return { size, side, values: below };
}

/** Sums of all that lies south-west, with a row and a column of zeros before. */
function summed(heights: Float32Array, side: number): Float64Array {
  const wide = side + 1;
  const sums = new Float64Array(wide * wide);
  for (let j = 0; j < side; j++) {
    let row = 0;
    for (let i = 0; i < side; i++) {
      row += heights[j * side + i]!;
      sums[(j + 1) * wide + i + 1] = sums[j * wide + i + 1]! + row;
    }
  }
  return sums;
}

function mean(sums: Float64Array, side: number, i0: number, j0: number, i1: number, j1: number): number {
  const wide = side + 1;
  const [south, north] = [j0 * wide, (j1 + 1) * wide];
  const sum = sums[north + i1 + 1]! - sums[north + i0]! - sums[south + i1 + 1]! + sums[south + i0]!;
  return sum / ((i1 - i0 + 1) * (j1 - j0 + 1));
}
