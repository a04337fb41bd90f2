import type { PackedTree } from '../pack/packed.ts';
import type { Species } from '../species/species.ts';
import type { CrownLight } from './crown-light.ts';
import { formLight } from './form-light.ts';
import { leafForm } from './leaf-shapes.ts';
import { leafSpecOf } from './leaf-spec.ts';

/** The light inside the crown of a tree in its leaves. */
export const treeLight = (tree: PackedTree, species: Species): CrownLight =>
  formLight(tree, species, leafForm(leafSpecOf(species)));
