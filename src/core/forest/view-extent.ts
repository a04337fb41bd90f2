import { leafPoints } from '../look/leaf-points.ts';
import { POSE_TARGETS, TEXEL } from '../pack/layout.ts';
import type { PackedTree } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';

/** What holds a tree from every side: metres, tree space. */
export interface ViewExtent {
  readonly centre: readonly [number, number, number];
  /** From the upright axis through the centre to what is farthest from it. */
  readonly halfWidth: number;
  /** From the centre to what is farthest from it. */
  readonly radius: number;
}

/** The extent of a tree at rest in which leaves reach `reach` metres beyond their feet. */
export function viewExtent(tree: PackedTree, reach: number): ViewExtent {
  const { bounds, restPose, pieceCount } = tree;
  const centre = [0, 1, 2].map((k) => (bounds[k]! + bounds[3 + k]!) / 2) as [number, number, number];
  let wide = 0;
  let far = 0;
  const take = (data: Float32Array, at: number, margin: number): void => {
    const [x, y, z] = [data[at]! - centre[0], data[at + 1]! - centre[1], data[at + 2]! - centre[2]];
    wide = Math.max(wide, Math.sqrt(x * x + y * y) + margin);
    far = Math.max(far, Math.sqrt(x * x + y * y + z * z) + margin);
  };
  const margin = 0.01 * (bounds[5]! - bounds[2]!);
  for (const target of [POSE_TARGETS.P0, POSE_TARGETS.P1, POSE_TARGETS.P2, POSE_TARGETS.P3]) {
    const start = layerStart(restPose, target);
    for (let i = 0; i < pieceCount; i++) take(restPose.data, start + TEXEL * i, margin);
  }
  const feet = leafPoints(tree, tree.leafCount);
  for (let i = 0; i < feet.length; i += 3) take(feet, i, reach);
  return { centre, halfWidth: wide, radius: far };
}
