import { LEAF_LAYERS, POSE_TARGETS, TEXEL } from '../pack/layout.ts';
import { GROVE_PIECES } from '../pack/leaf-texel.ts';
import type { PackedTree } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';

/** Feet of the stalks of the first `most` leaves of the draw order at rest, which are spread evenly over the crown: 3 a leaf, tree space. */
export function leafPoints(tree: PackedTree, most: number): Float32Array {
  const { leafCount, leaves, restPose } = tree;
  // In a grove the tree stands in the bits above the piece's.
  const pieceBits = 'treeCount' in tree ? GROVE_PIECES - 1 : 0x7fffffff;
  const count = Math.min(leafCount, Math.max(0, Math.floor(most)));
  const out = new Float32Array(3 * count);
  const { data } = restPose;
  const first = layerStart(leaves, LEAF_LAYERS.LEAF);
  const [a, b, c, d] = [POSE_TARGETS.P0, POSE_TARGETS.P1, POSE_TARGETS.P2, POSE_TARGETS.P3].map((target) =>
    layerStart(restPose, target),
  ) as [number, number, number, number];
  for (let i = 0; i < count; i++) {
    const t = first + TEXEL * i;
    const piece = TEXEL * (leaves.data[t]! & pieceBits);
    const u = (leaves.data[t + 1]! & 0xffff) / 65535;
    const w = 1 - u;
    for (let k = 0; k < 3; k++) {
      const at = piece + k;
      out[3 * i + k] =
        w * w * w * data[a + at]! +
        3 * w * w * u * data[b + at]! +
        3 * w * u * u * data[c + at]! +
        u * u * u * data[d + at]!;
    }
  }
  return out;
}
