import { BRANCH_LAYERS, PIECE_LAYERS, POSE_TARGETS, TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree, TexelArray } from '../../core/pack/packed.ts';
import { layerStart, texelArray } from '../../core/pack/texel-array.ts';

/**
 * Many copies of a tree as one, sorted by depth as the wind pass wants it: as good as a large tree for timing, and made a hundred times as fast. It has
 * no leaves, and all copies stand in one place.
 */
export function tiledTree(tree: PackedTree, copies: number): PackedTree {
  if (copies === 1) return tree;
  const { depthStart } = tree;
  const pieceCount = tree.pieceCount * copies;
  const starts = depthStart.map((start) => start * copies);
  const pieces = texelArray(pieceCount, Object.keys(PIECE_LAYERS).length);
  const restPose = texelArray(pieceCount, Object.keys(POSE_TARGETS).length);
  const branches = texelArray(pieceCount, Object.keys(BRANCH_LAYERS).length);
  const perPiece = tree.mechanics.length / tree.pieceCount;
  const mechanics = new Float32Array(perPiece * pieceCount);
  const copyLayers = (from: TexelArray, to: TexelArray, first: number, count: number, target: number): void => {
    for (let layer = 0; layer < from.layers; layer++) {
      const begin = layerStart(from, layer) + TEXEL * first;
      to.data.set(from.data.subarray(begin, begin + TEXEL * count), layerStart(to, layer) + TEXEL * target);
    }
  };
  const attach = layerStart(pieces, PIECE_LAYERS.ATTACH);
  for (let depth = 0; depth + 1 < depthStart.length; depth++) {
    const first = depthStart[depth] as number;
    const count = (depthStart[depth + 1] as number) - first;
    const before = depth === 0 ? 0 : (depthStart[depth - 1] as number);
    for (let copy = 0; copy < copies; copy++) {
      const target = (starts[depth] as number) + copy * count;
      copyLayers(tree.pieces, pieces, first, count, target);
      copyLayers(tree.restPose, restPose, first, count, target);
      copyLayers(tree.branches, branches, first, count, target);
      mechanics.set(tree.mechanics.subarray(perPiece * first, perPiece * (first + count)), perPiece * target);
      if (depth === 0) continue;
      // A parent is of the depth before: it has moved with its copy.
      const moved = (starts[depth - 1] as number) + copy * (first - before) - before;
      for (let i = 0; i < count; i++) {
        const at = attach + TEXEL * (target + i);
        pieces.data[at] = (pieces.data[at] as number) + moved;
      }
    }
  }
  const levels = starts.length - 1;
  return {
    ...tree,
    pieceCount,
    leafCount: 0,
    depthStart: starts,
    pieces,
    restPose,
    branches,
    mechanics,
    levels: Array.from({ length: levels }, (_, d) => ({
      start: starts[d] as number,
      count: (starts[d + 1] as number) - (starts[d] as number),
    })),
  };
}
