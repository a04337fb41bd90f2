import type { ForestDocument, TreePlaces } from '../../core/forest/forest.ts';
import { type HeightField, slopeAt } from '../../core/forest/height-field.ts';
import { combine } from '../../core/math/hash.ts';
import type { Species } from '../../core/species/species.ts';

/** Bytes of the pictures of one tree from all sides, about, and the part of a forest's memory that all of them may take. */
const PICTURE_BYTES = 2.8 * 2 ** 20;
const PICTURE_PART = 0.15;
/** Few tell more shapes than that from unique trees, each with a turn of its own; the pictures of each take time at the start. */
const MOST_VARIANTS = 16;

/** How many shapes each species of a mix has: as many as memory holds, none more than it has trees, nor than `most`. */
export function variantCounts(trees: readonly number[], memoryBudget: number, most = MOST_VARIANTS): number[] {
  const present = Math.max(1, trees.filter((count) => count > 0).length);
  const each = Math.floor((PICTURE_PART * memoryBudget) / PICTURE_BYTES / present);
  return trees.map((count) => Math.min(count, most, Math.max(1, each)));
}

/** Trees of each species of the mix among the first `count`. */
export function treesOf({ species }: TreePlaces, count: number, mix: number): number[] {
  const trees = new Array<number>(mix).fill(0);
  for (let i = 0; i < count; i++) trees[species[i] as number]!++;
  return trees;
}

/** The seed of a variant: that of the forest, of the species' place in the mix, and of its number; 31 bits. */
export const variantSeed = ({ seed }: Pick<ForestDocument, 'seed'>, species: number, variant: number): number =>
  combine(combine(seed, species), variant) >>> 1;

/** Metres of a tree's height by which it is sunk in level ground, and, of the width of its foot, on a slope: no root hangs in the air. */
const SUNK = 0.004;
const FOOT = 0.022;

/** Heights of the feet of all trees: in the ground on the lower side too. `heights`: of the trees, metres. */
export function footHeights(field: HeightField, places: TreePlaces, heights: ArrayLike<number>): Float32Array {
  return places.z.map((z, i) => {
    const slope = Math.tan(slopeAt(field, places.x[i] as number, places.y[i] as number));
    return z - (heights[i] as number) * (SUNK + FOOT * Math.min(1.5, slope));
  });
}

/** The height that a species' tallest trees may have, metres: for what is not grown yet, and for what must not be missed. */
export const mostHeight = ({ tree, levels }: Species): number =>
  Math.max(1, (tree.scale + tree.scaleV) * Math.max(0.5, (levels[0]?.length ?? 1) + (levels[0]?.lengthV ?? 0)));
