import { MECHANICS_SIZE, PIECE_LAYERS, POSE_TARGETS, TEXEL } from '../pack/layout.ts';
import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart, texelArray } from '../pack/texel-array.ts';
import type { Pieces } from '../pieces/pieces.ts';

/** The pieces below a level as a tree of its own, as far as wind moves them: they move as they do in the whole tree. */
export interface BonedTree {
  readonly tree: Pick<PackedTree, 'pieceCount' | 'pieces' | 'restPose' | 'mechanics'>;
  /** By piece of the whole tree: its index here, -1 where it is left out. */
  readonly at: Int32Array;
}

/** The pieces of the stems below `levels`; no piece grows on one of a deeper level. */
export function bonedTree(
  packed: PackedTree,
  { level, count }: Pick<Pieces, 'level' | 'count'>,
  levels: number,
): BonedTree {
  const at = new Int32Array(count).fill(-1);
  const kept: number[] = [];
  for (let i = 0; i < count; i++) {
    if (level[i]! >= levels) continue;
    at[i] = kept.length;
    kept.push(i);
  }
  const pieces = texelArray(kept.length, Object.keys(PIECE_LAYERS).length);
  const restPose = texelArray(kept.length, Object.keys(POSE_TARGETS).length);
  copy(packed.pieces, pieces, kept);
  copy(packed.restPose, restPose, kept);
  const attach = layerStart(pieces, PIECE_LAYERS.ATTACH);
  const mechanics = new Float32Array(MECHANICS_SIZE * kept.length);
  kept.forEach((piece, i) => {
    const parent = pieces.data[attach + TEXEL * i]!;
    if (parent >= 0) pieces.data[attach + TEXEL * i] = at[parent]!;
    mechanics.set(packed.mechanics.subarray(MECHANICS_SIZE * piece, MECHANICS_SIZE * (piece + 1)), MECHANICS_SIZE * i);
  });
  return { tree: { pieceCount: kept.length, pieces, restPose, mechanics }, at };
}

function copy(from: TexelArray, to: TexelArray, kept: readonly number[]): void {
  for (let layer = 0; layer < to.layers; layer++) {
    const source = layerStart(from, layer);
    const target = layerStart(to, layer);
    kept.forEach((piece, i) => {
      to.data.set(from.data.subarray(source + TEXEL * piece, source + TEXEL * (piece + 1)), target + TEXEL * i);
    });
  }
}
