import type { ForestDocument, TreePlaces } from '../../core/forest/forest.ts';
import { checkField, type HeightField } from '../../core/forest/height-field.ts';
import { inSeason } from '../../core/species/season.ts';
import type { Species } from '../../core/species/species.ts';
import { type CellGrid, cellGrid, MIDDLE_CELL, NEAR_CELL } from './cells.ts';
import { footHeights, mostHeight, treesOf, variantCounts } from './forest-plan.ts';

/** A forest as it is to be drawn: which tree stands where and in what shape. */
export interface ForestSetup {
  readonly document: ForestDocument;
  readonly field: HeightField;
  /** The species of the mix, in the season. */
  readonly mix: readonly Species[];
  readonly places: TreePlaces;
  /** Heights of their feet, metres, forest space. */
  readonly feet: Float32Array;
  /** Shapes that each species has, and its trees. */
  readonly variants: readonly number[];
  readonly trees: readonly number[];
  readonly near: CellGrid;
  readonly middle: CellGrid;
}

/** The variant of a tree. */
export const variantOf = ({ places, variants }: ForestSetup, tree: number): number =>
  (places.variant[tree] as number) % (variants[places.species[tree] as number] as number);

/**
 * Plans a forest: a tree that is not grown yet counts as tall as its species
 * says. Throws Error naming the species of the mix that is not in `species`, RangeError where the ground or the memory is no number.
 */
export function setUpForest(
  document: ForestDocument,
  species: ReadonlyMap<string, Species>,
  field: HeightField,
  places: TreePlaces,
  memoryBudget: number,
  mostVariants?: number,
): ForestSetup {
  checkField(field);
  if (!(memoryBudget >= 0)) throw new RangeError(`A memory budget of ${memoryBudget}: bytes, 0 or more.`);
  const mix = document.mix.map(({ species: id }) => {
    const found = species.get(id);
    if (!found) throw new Error(`The forest has trees of '${id}', which is no species that was given.`);
    return inSeason(found, document.season);
  });
  const trees = treesOf(places, places.count, mix.length);
  const heights = Float32Array.from({ length: places.count }, (_, i) =>
    mostHeight(mix[places.species[i] as number] as Species),
  );
  return {
    document,
    field,
    mix,
    places,
    feet: footHeights(field, places, heights),
    trees,
    variants: variantCounts(trees, memoryBudget, mostVariants),
    near: cellGrid(places, places.count, heights, document.size, NEAR_CELL),
    middle: cellGrid(places, places.count, heights, document.size, MIDDLE_CELL),
  };
}
