import { PIECE_LAYERS } from '../pack/layout.ts';
import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart, texelArray, wordTexels } from '../pack/texel-array.ts';

/** Numbers a piece of the per-piece arrays beside the texels: `mechanics`, where the tree has them. */
const perPiece = <Data extends Float32Array>(data: Data, count: number, picked: Uint32Array): Float32Array => {
  const each = count > 0 ? data.length / count : 0;
  const out = new Float32Array(each * picked.length);
  picked.forEach((piece, k) => {
    out.set(data.subarray(each * piece, each * (piece + 1)), each * k);
  });
  return out;
};

function pickTexels(from: TexelArray, picked: Uint32Array): TexelArray {
  const out = texelArray(picked.length, from.layers);
  for (let layer = 0; layer < from.layers; layer++) {
    const source = layerStart(from, layer);
    const target = layerStart(out, layer);
    picked.forEach((piece, k) => {
      const at = source + 4 * piece;
      out.data.set(from.data.subarray(at, at + 4), target + 4 * k);
    });
  }
  return out;
}

/** The pieces from the root to `piece`, the root first. Throws RangeError where there is no such piece. */
export function piecesTo({ pieces, pieceCount }: PackedTree, piece: number): Uint32Array {
  if (!(Number.isInteger(piece) && piece >= 0 && piece < pieceCount)) throw new RangeError(`no piece ${piece}`);
  const attach = layerStart(pieces, PIECE_LAYERS.ATTACH);
  const found: number[] = [];
  for (let i = piece; i >= 0; i = pieces.data[attach + 4 * i]) found.push(i);
  return Uint32Array.from(found.reverse());
}

/**
 * One piece of a tree with its ancestors alone, as a tree of its own: what the bend and the pose of a piece depend on, and nothing
 * else. So every function that takes a whole tree answers for one branch in microseconds. Its last piece is the one asked for.
 */
export function chainOf(tree: PackedTree, piece: number): PackedTree {
  const picked = piecesTo(tree, piece);
  const count = picked.length;
  const pieces = pickTexels(tree.pieces, picked);
  const attach = layerStart(pieces, PIECE_LAYERS.ATTACH);
  for (let k = 0; k < count; k++) pieces.data[attach + 4 * k] = k - 1;
  const chain: PackedTree = {
    ...tree,
    pieceCount: count,
    leafCount: 0,
    depthStart: Uint32Array.from({ length: count + 1 }, (_, k) => k),
    pieces,
    restPose: pickTexels(tree.restPose, picked),
    branches: texelArray(0, tree.branches.layers),
    leaves: wordTexels(0, tree.leaves.layers),
    levels: [],
  };
  return { ...chain, mechanics: perPiece(tree.mechanics, tree.pieceCount, picked) };
}
