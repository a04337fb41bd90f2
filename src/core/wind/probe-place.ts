import { BRANCH_LAYERS, POSE_TARGETS } from '../pack/layout.ts';
import type { PackedTree } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';

/** Where in a tree a piece is. */
export interface PiecePlace {
  readonly piece: number;
  /** Level of its stem; 0 is the trunk. */
  readonly level: number;
  /** Part of its stem that it covers, 0 at the base to 1 at the tip. */
  readonly z0: number;
  readonly z1: number;
  /** Of its stem, metres. */
  readonly length: number;
  /** Height of its end at rest, metres. */
  readonly height: number;
  /** Its end at rest, tree space, metres. */
  readonly end: readonly [number, number, number];
}

/** The place in the draw order of every piece, and the level of its stem. */
export interface PieceIndex {
  readonly place: Uint32Array;
  readonly level: Uint8Array;
}

export function indexPieces({ pieceCount, branches, levels }: PackedTree): PieceIndex {
  const place = new Uint32Array(pieceCount);
  const level = new Uint8Array(pieceCount);
  const span = layerStart(branches, BRANCH_LAYERS.SPAN);
  levels.forEach(({ start, count }, l) => {
    for (let i = start; i < start + count; i++) {
      const piece = branches.data[span + 4 * i];
      place[piece] = i;
      level[piece] = l;
    }
  });
  return { place, level };
}

export function placeOfPiece({ branches, restPose }: PackedTree, index: PieceIndex, piece: number): PiecePlace {
  const span = layerStart(branches, BRANCH_LAYERS.SPAN) + 4 * index.place[piece];
  const stem = layerStart(branches, BRANCH_LAYERS.STEM) + 4 * index.place[piece];
  const p3 = layerStart(restPose, POSE_TARGETS.P3) + 4 * piece;
  const { data } = restPose;
  return {
    piece,
    level: index.level[piece],
    z0: branches.data[span + 1],
    z1: branches.data[span + 2],
    length: branches.data[stem],
    height: data[p3 + 2],
    end: [data[p3], data[p3 + 1], data[p3 + 2]],
  };
}

/**
 * Where a probe sits that nobody has placed: at the end of a limb (a stem of level 1; the trunk of a tree without), near half of the
 * tree's height, of those the longer ones first.
 */
export function defaultPiece(tree: PackedTree, index: PieceIndex): number {
  const middle = (tree.bounds[2] + tree.bounds[5]) / 2;
  const size = Math.max(1e-6, tree.bounds[5] - tree.bounds[2]);
  const level = tree.levels.length > 1 && tree.levels[1].count > 0 ? 1 : 0;
  let best = 0;
  let least = Number.POSITIVE_INFINITY;
  for (let piece = 0; piece < tree.pieceCount; piece++) {
    if (index.level[piece] !== level) continue;
    const { z1, height, length } = placeOfPiece(tree, index, piece);
    const cost = Math.abs(height - middle) / size - (0.3 * length) / size + (z1 > 0.999 ? 0 : 10);
    if (cost < least) {
      least = cost;
      best = piece;
    }
  }
  return best;
}
