import type { PackedTree } from '../pack/packed.ts';
import type { Species } from '../species/species.ts';
import type { CrownLight } from './crown-light.ts';
import { treeLight } from './tree-light.ts';

/**
 * The light inside a crown, of which the box is told in radii of the crown about its centre, along the tree's own axes: one field does for
 * all trees of a species, whatever the size of their crowns.
 */
export interface GroveLight extends CrownLight {
  readonly inRadii: true;
}

/** The light that one tree finds for all of its species. */
export function groveLight(tree: PackedTree, species: Species): GroveLight {
  const { cells, data, low, size } = treeLight(tree, species);
  const { crown } = tree;
  const from = (k: 0 | 1 | 2): number => (low[k] - (crown[k] as number)) / (crown[3 + k] as number);
  const across = (k: 0 | 1 | 2): number => size[k] / (crown[3 + k] as number);
  return {
    inRadii: true,
    cells,
    data,
    low: [from(0), from(1), from(2)],
    size: [across(0), across(1), across(2)],
  };
}
