import { MECHANICS, MECHANICS_SIZE, PIECE_LAYERS, TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { StemTable } from '../../core/pack/stem-table.ts';

/** A place on a piece. */
export interface PlaceOnPiece {
  readonly piece: number;
  /** Bezier parameter, 0..1. */
  readonly v: number;
}

/** Where the handles of a stem sit. */
export interface StemEnds {
  readonly stem: number;
  readonly level: number;
  readonly base: PlaceOnPiece;
  /** A little beyond the middle: the arc of the down angle reaches almost to that. */
  readonly middle: PlaceOnPiece;
  readonly tip: PlaceOnPiece;
  /** Where it grows on its parent; null for a trunk, whose angle is that with the vertical. */
  readonly parent: PlaceOnPiece | null;
  /** A clone leaves its twin by the angle of the split, which no level's down angle gives. */
  readonly down: boolean;
}

/** Part of the stem at which the handle of the curve sits. */
export const MIDDLE = 0.55;

/** The places of a stem's handles. */
export function stemEnds(tree: PackedTree, stems: StemTable, stem: number): StemEnds {
  const { pieces, mechanics, pieceCount } = tree;
  const first = stems.firstPiece[stem] as number;
  const chain = [first];
  for (let i = first + 1; i < pieceCount; i++) if (stems.stemOfPiece[i] === stem) chain.push(i);
  const span = (piece: number, end: 'Z0' | 'Z1'): number =>
    mechanics[piece * MECHANICS_SIZE + MECHANICS[end]] as number;
  const from = span(first, 'Z0');
  const wanted = from + (1 - from) * MIDDLE;
  const middle = chain.find((piece) => span(piece, 'Z1') >= wanted) ?? first;
  const [z0, z1] = [span(middle, 'Z0'), span(middle, 'Z1')];
  const attach = PIECE_LAYERS.ATTACH * pieces.width * pieces.height * TEXEL + TEXEL * first;
  const above = pieces.data[attach] as number;
  return {
    stem,
    level: stems.level[stem] as number,
    base: { piece: first, v: 0 },
    middle: { piece: middle, v: (wanted - z0) / (z1 - z0 || 1) },
    tip: { piece: chain[chain.length - 1] as number, v: 1 },
    parent: above < 0 ? null : { piece: above, v: pieces.data[attach + 1] as number },
    down: stems.clone[stem] === 0,
  };
}
