import { BRANCH_LAYERS } from '../pack/layout.ts';
import type { PackedTree } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';

/** What the branch deformer knows of each piece, by its index; one entry a piece. */
export interface PieceTable {
  /** Part [z0, z1] of its stem. */
  readonly z0: Float32Array;
  readonly z1: Float32Array;
  /** Of the stem, metres: radius at its base, length, radius of what it grows on where it starts (0 for a trunk). */
  readonly baseRadius: Float32Array;
  readonly length: Float32Array;
  readonly parentRadius: Float32Array;
  /** Phase of the bark, turns. */
  readonly phase: Float32Array;
}

/** The draw order's texels, sorted back by piece. */
export function pieceTable({ branches, pieceCount }: Pick<PackedTree, 'branches' | 'pieceCount'>): PieceTable {
  const { data } = branches;
  const span = layerStart(branches, BRANCH_LAYERS.SPAN);
  const stem = layerStart(branches, BRANCH_LAYERS.STEM);
  const column = (): Float32Array => new Float32Array(pieceCount);
  const table = {
    z0: column(),
    z1: column(),
    baseRadius: column(),
    length: column(),
    parentRadius: column(),
    phase: column(),
  };
  for (let place = 0; place < pieceCount; place++) {
    const t = 4 * place;
    const piece = data[span + t]!;
    table.z0[piece] = data[span + t + 1]!;
    table.z1[piece] = data[span + t + 2]!;
    table.baseRadius[piece] = data[span + t + 3]!;
    table.length[piece] = data[stem + t]!;
    table.phase[piece] = data[stem + t + 1]!;
    table.parentRadius[piece] = data[stem + t + 3]!;
  }
  return table;
}
