import type { PackedTree } from '../pack/packed.ts';
import type { Species } from '../species/species.ts';
import { bladeArea } from './blade.ts';
import { type CrownLight, crownLight } from './crown-light.ts';
import { leafPoints } from './leaf-points.ts';
import { leafForm, leafSpecOf } from './leaf-shapes.ts';

/** Leaves that are looked at: more do not change a grid so coarse. */
const MOST = 12_000;

/** The light inside the crown of a tree in its leaves. */
export function treeLight(tree: PackedTree, species: Species): CrownLight {
  const { foliage } = species;
  const spec = leafSpecOf(species);
  const length = tree.leafLength * foliage.size;
  const points = leafPoints(tree, MOST);
  const each = bladeArea(leafForm(spec).blades(spec.width, 'far')) * length * length * foliage.cover;
  return crownLight(points, (each * 3 * tree.leafCount) / Math.max(points.length, 1));
}
