import type { PackedTree } from '../pack/packed.ts';
import type { Species } from '../species/species.ts';
import { formArea, type LeafForm } from './blade.ts';
import { type CrownLight, crownLight } from './crown-light.ts';
import { leafPoints } from './leaf-points.ts';

/** Leaves that are looked at: more do not change a grid so coarse. */
const MOST = 12_000;

/** The light inside the crown of a tree in leaves of a form. */
export function formLight(tree: PackedTree, { foliage, leaves }: Species, form: LeafForm): CrownLight {
  const length = tree.leafLength * foliage.size;
  const points = leafPoints(tree, MOST);
  const each = formArea(form, leaves.scaleX, 'far') * length * length * foliage.cover;
  return crownLight(points, (each * 3 * tree.leafCount) / Math.max(points.length, 1));
}
