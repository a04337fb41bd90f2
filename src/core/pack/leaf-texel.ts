import type { Quaternion } from '../math/quaternion.ts';
import { TEXEL } from './layout.ts';

/** A leaf as its texel holds it: place and phase to 16 bits, rotation to 3e-5 rad. */
export interface LeafTexel {
  /** Index of the piece, below 2^31. */
  piece: number;
  /** Is the depth of the piece odd? */
  odd: boolean;
  /** Bezier parameter on the piece, 0..1. */
  v: number;
  /** Phase of the leaf's own motion in turns, 0..1. */
  phase: number;
  /** Rotation of the leaf in the piece's section frame at v. */
  orientation: Quaternion;
}

/** Bits of a leaf's first word that hold its piece in a grove; those from there to the top bit hold the tree. */
export const GROVE_PIECE_BITS = 20;
/** Pieces and trees that a grove has at most: as many as those bits tell apart. */
export const GROVE_PIECES = 1 << GROVE_PIECE_BITS;
export const GROVE_TREES = 1 << (31 - GROVE_PIECE_BITS);

/** Piece and tree of a leaf of a grove, from its first word. Twin: shaders/leaf/texel.glsl. */
export const groveLeaf = (word: number): { piece: number; tree: number } => ({
  piece: word & (GROVE_PIECES - 1),
  tree: (word >>> GROVE_PIECE_BITS) & (GROVE_TREES - 1),
});

/** A number of 0..1 in 16 bits, as GLSL's packUnorm2x16 rounds it. */
const unorm = (x: number): number => Math.floor(x * 65535 + 0.5);
/** A number of -1..1 in 16 bits, as GLSL's packSnorm2x16 rounds it. */
const snorm = (x: number): number => Math.floor(x * 32767 + 0.5) & 0xffff;
const fromSnorm = (bits: number): number => Math.max(-1, ((bits << 16) >> 16) / 32767);

/** Writes the texel of leaf `place`; the rotation is four numbers of `q` from `at`. Allocates nothing. */
export function writeLeaf(
  data: Uint32Array,
  place: number,
  piece: number,
  odd: boolean,
  v: number,
  phase: number,
  q: ArrayLike<number>,
  at: number,
): void {
  const t = TEXEL * place;
  data[t] = odd ? piece | 0x80000000 : piece;
  data[t + 1] = unorm(v) | (unorm(phase) << 16);
  data[t + 2] = snorm(q[at]) | (snorm(q[at + 1]) << 16);
  data[t + 3] = snorm(q[at + 2]) | (snorm(q[at + 3]) << 16);
}

/** The leaf at `place` of the draw order. Twin: shaders/leaf/texel.glsl. */
export function leafTexel(data: Uint32Array, place: number): LeafTexel {
  const t = TEXEL * place;
  const [a, b, c, d] = [data[t], data[t + 1], data[t + 2], data[t + 3]];
  return {
    piece: a & 0x7fffffff,
    odd: a >>> 31 === 1,
    v: (b & 0xffff) / 65535,
    phase: (b >>> 16) / 65535,
    orientation: [fromSnorm(c), fromSnorm(c >>> 16), fromSnorm(d), fromSnorm(d >>> 16)],
  };
}
