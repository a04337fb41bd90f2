import { Box3, Vector3 } from 'three';
import { BRANCH_LAYERS, TEXEL } from '../core/pack/layout.ts';
import type { PackedTree } from '../core/pack/packed.ts';

/** What the choice of detail and the culling need to know of one level. */
export interface LevelExtent {
  /** Box around the level's pieces at rest, tree space. */
  readonly box: Box3;
  /** Radius in metres that four of five stems of the level stay below. */
  readonly radius: number;
  /** How many radii long its pieces are. */
  readonly slenderness: number;
}

/** Stems that are looked at to judge a level's radius; the draw order is spread evenly, so its start is a fair sample. */
const SAMPLE = 256;

/** Box and typical radius of each level, from the packed tree; of the first `most` pieces of its draw order. */
export function levelExtents(tree: PackedTree, most = Number.POSITIVE_INFINITY): LevelExtent[] {
  const { branches, restPose, levels } = tree;
  const plane = restPose.width * restPose.height * TEXEL;
  const span = BRANCH_LAYERS.SPAN * branches.width * branches.height * TEXEL;
  const point = new Vector3();
  const before = new Vector3();
  return levels.map(({ start, count: all }) => {
    const count = Math.min(all, most);
    const box = new Box3();
    const radii: number[] = [];
    let length = 0;
    for (let i = start; i < start + count; i++) {
      const t = span + i * TEXEL;
      const piece = branches.data[t] as number;
      const radius = branches.data[t + 3] as number;
      if (radii.length < SAMPLE) radii.push(radius);
      // The control polygon holds the curve.
      for (let k = 0; k < 4; k++) {
        box.expandByPoint(point.fromArray(restPose.data, k * plane + piece * TEXEL));
        length += k > 0 ? point.distanceTo(before) : 0;
        before.copy(point);
      }
    }
    radii.sort((a, b) => a - b);
    const radius = radii[Math.floor(radii.length * 0.8)] ?? 0;
    const slenderness = length / Math.max(1, count) / Math.max(radius, 1e-6);
    return { box: box.expandByScalar((radii[radii.length - 1] ?? 0) * 2), radius, slenderness };
  });
}

/** The tree's box with room for what the wind does to it: a tenth of its height to each side, a twentieth up. */
export function windBox(bounds: Float32Array): Box3 {
  const box = new Box3(new Vector3().fromArray(bounds, 0), new Vector3().fromArray(bounds, 3));
  const height = box.max.z - box.min.z;
  box.expandByVector(new Vector3(0.1 * height, 0.1 * height, 0.05 * height));
  return box;
}

/** The box of a packed tree (z up: min x, y, z, max x, y, z) as the box that it fills in a scene (y up). */
export function uprightBox(bounds: Float32Array): Box3 {
  const [x0, y0, z0, x1, y1, z1] = bounds;
  return new Box3(new Vector3(x0, z0, -y1), new Vector3(x1, z1, -y0));
}
