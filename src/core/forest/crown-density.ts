import { formArea } from '../look/blade.ts';
import { leafForm, leafSpecOf } from '../look/leaf-shapes.ts';
import { BRANCH_LAYERS, TEXEL } from '../pack/layout.ts';
import type { PackedTree } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';
import type { Species } from '../species/species.ts';

/** Part of its area that a leaf hides on the average of all directions, and how much less leaves hide that stand in clumps: fitted to shadow maps. */
const HIDES = 0.5 * 0.9;

/** Part of its length times its width at the base that a stem hides: it tapers, and is seen aslant. */
const WOOD = 0.6 * 0.785;

/** Length times width of all stems of level 1 and above, square metres. */
function woodArea({ branches, levels }: PackedTree): number {
  const span = layerStart(branches, BRANCH_LAYERS.SPAN);
  const stem = layerStart(branches, BRANCH_LAYERS.STEM);
  const { data } = branches;
  let area = 0;
  for (const { start, count } of levels.slice(1)) {
    for (let t = TEXEL * start; t < TEXEL * (start + count); t += TEXEL) {
      area += 2 * data[span + t + 3]! * (data[span + t + 2]! - data[span + t + 1]!) * data[stem + t]!;
    }
  }
  return area;
}

/** How fast light is lost in the crown's ellipsoid: its share left after s metres is exp(-density s); 1/m. */
export function crownDensity(tree: PackedTree, species: Species): number {
  const { foliage } = species;
  const spec = leafSpecOf(species);
  const length = tree.leafLength * foliage.size;
  const area = formArea(leafForm(spec), spec.width, 'far') * length * length * foliage.cover * tree.leafCount;
  const [rx, ry, rz] = tree.crown.subarray(3, 6) as unknown as [number, number, number];
  return (HIDES * area + WOOD * woodArea(tree)) / ((4 / 3) * Math.PI * rx * ry * rz);
}
