import { BRANCH_LAYERS, PIECE_LAYERS, TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';

/** Is the depth of a piece odd? Then its pose is in the odd set of textures. */
export function isOdd({ depthStart }: PackedTree, piece: number): boolean {
  let depth = 0;
  while (depth + 1 < depthStart.length && (depthStart[depth + 1] as number) <= piece) depth++;
  return depth % 2 === 1;
}

/**
 * The pieces of the stem that a piece belongs to, from its base on: piece | 1 where its depth is odd | radius in metres at its
 * start | at its end; 4 a piece.
 */
export function stemPieces(tree: PackedTree, piece: number): Float32Array {
  const { pieces, branches, pieceCount } = tree;
  const plane = pieces.width * pieces.height * TEXEL;
  const parentOf = (i: number): number => pieces.data[PIECE_LAYERS.ATTACH * plane + i * TEXEL] as number;
  // All pieces of a stem, and no others, feel the wind at the same place: the tip of the stem.
  const tip = PIECE_LAYERS.TIP * plane;
  const together = (i: number, j: number): boolean =>
    [0, 1, 2].every((k) => pieces.data[tip + i * TEXEL + k] === pieces.data[tip + j * TEXEL + k]);
  let first = piece;
  for (let p = parentOf(first); p >= 0 && together(p, piece); p = parentOf(first)) first = p;
  const chain = [first];
  for (let i = first + 1; i < pieceCount; i++) {
    if (parentOf(i) === chain[chain.length - 1] && together(i, piece)) chain.push(i);
  }
  const out = new Float32Array(4 * chain.length);
  const span = BRANCH_LAYERS.SPAN * branches.width * branches.height * TEXEL;
  const place = new Map(chain.map((i, k) => [i, k]));
  for (let i = 0; i < pieceCount; i++) {
    const t = span + i * TEXEL;
    const number = branches.data[t] as number;
    const k = place.get(number);
    if (k === undefined) continue;
    const radius = branches.data[t + 3] as number;
    const taper = (z: number): number => radius * (1 - 0.9 * z);
    out.set(
      [
        number,
        isOdd(tree, number) ? 1 : 0,
        taper(branches.data[t + 1] as number),
        taper(branches.data[t + 2] as number),
      ],
      4 * k,
    );
  }
  return out;
}
