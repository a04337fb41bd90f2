import { BRANCH_LAYERS, TEXEL } from '../pack/layout.ts';
import type { PackedTree } from '../pack/packed.ts';
import { type Fractions, type Item, POINT_MASS } from './fractions.ts';

/**
 * How the paper's aspen is cut up, as the counts of its Table 2 tell: a stem is drawn as `lines` pieces of line, or as a tube of `bands`
 * bands with `sectors` sides (triangles: twice their product), the trunk once and every other stem alike.
 */
export const STEM_FORM: Readonly<Record<Exclude<Item, 'leaves'>, StemForm>> = {
  trunk: { lines: 36, bands: 36, sectors: 20 },
  main: { lines: 8, bands: 4, sectors: 4 },
  other: { lines: 8, bands: 4, sectors: 3 },
};

export interface StemForm {
  /** A stem. */
  readonly lines: number;
  readonly bands: number;
  readonly sectors: number;
}

/** Which rule a level follows: those beyond the third go with it. */
export const itemOf = (level: number): 'trunk' | 'main' | 'other' => (['trunk', 'main'] as const)[level] ?? 'other';

/** Parts that a piece over [z0, z1] of its stem gets where the stem has `parts`; at least 1. Twin: shaders/branch/part.glsl */
export const partsOfPiece = (z0: number, z1: number, parts: number): number =>
  Math.max(1, Math.floor(parts * z1 + 0.5) - Math.floor(parts * z0 + 0.5));

/** Parts of a level before each place of its draw order; the last entry is how many there are. */
export function partSums({ branches, levels }: PackedTree, level: number, parts: number): Uint32Array {
  const { start, count } = levels[level] ?? { start: 0, count: 0 };
  const span = BRANCH_LAYERS.SPAN * branches.width * branches.height * TEXEL;
  const sums = new Uint32Array(count + 1);
  for (let k = 0; k < count; k++) {
    const t = span + (start + k) * TEXEL;
    sums[k + 1] =
      (sums[k] as number) + partsOfPiece(branches.data[t + 1] as number, branches.data[t + 2] as number, parts);
  }
  return sums;
}

/** A prefix of a draw order that ends inside an element: `elements` of `total`, the last at `cut` (place and part of what stands there). */
export interface Prefix {
  /** Elements begun. */
  readonly elements: number;
  /** Places, and as a fraction how much of the one at the border. */
  readonly cut: number;
}

/** The first `fraction` of what `sums` counts. The paper takes so many of every mass; a spread order needs no masses. */
export function prefixOf(sums: Uint32Array, fraction: number): Prefix {
  const places = sums.length - 1;
  const total = sums[places] ?? 0;
  const wanted = fraction * total;
  if (wanted >= total) return { elements: total, cut: places };
  let low = 0;
  let high = places;
  // The last place whose sum is not above what is wanted.
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((sums[middle] as number) <= wanted) low = middle;
    else high = middle;
  }
  const before = sums[low] ?? 0;
  const size = (sums[low + 1] ?? before + 1) - before;
  return { elements: Math.round(wanted), cut: low + (wanted - before) / size };
}

/** How many of `count` leaves are drawn as polygons, and how many as points, counted from the first; real numbers. */
export function leafPrefixes(
  count: number,
  { leaves }: Fractions,
): { readonly polygons: number; readonly points: number } {
  return {
    polygons: count * leaves.polygons,
    // One element a mass remains however far away the tree is (Weber & Penn 1995, section 5).
    points: Math.max(count * leaves.thin, Math.min(count, Math.ceil(count / POINT_MASS))),
  };
}
