import { halfBits, halfValue } from '../io/half.ts';
import type { Vec3 } from '../math/vec3.ts';
import { TEXEL } from './layout.ts';

/** Pictures of clumps that a species has. */
export const CARD_PICTURES = 4;

/** A card, a camera-facing picture of a clump of leaves, as its texel holds it. */
export interface CardTexel {
  /** The piece that carries it. */
  readonly piece: number;
  /** Is the depth of the piece odd? */
  readonly odd: boolean;
  /** Bezier parameter on the piece, 0..1, in 16 bits. */
  readonly v: number;
  /** A number of its own, 0..1, in 16 bits. */
  readonly phase: number;
  /** From the place on the piece to the clump's middle, metres in the piece's section frame at v, in halves of 11 bits. */
  readonly offset: Vec3;
  /** Half of the side of the card, metres, to 1 part in 250. */
  readonly radius: number;
  /** 0 .. CARD_PICTURES - 1. */
  readonly picture: number;
}

/** A number of 0..1 in 16 bits, as GLSL's packUnorm2x16 rounds it. */
const unorm = (x: number): number => Math.floor(x * 65535 + 0.5);

/** Writes the card of `place`. The radius lends its last two bits to the picture. Twin: shaders/forest/card-texel.glsl. */
export function writeCard(data: Uint32Array, place: number, card: CardTexel): void {
  const t = TEXEL * place;
  const [x, y, z] = card.offset;
  data[t] = card.odd ? card.piece | 0x80000000 : card.piece;
  data[t + 1] = unorm(card.v) | (unorm(card.phase) << 16);
  data[t + 2] = halfBits(x) | (halfBits(y) << 16);
  data[t + 3] = halfBits(z) | (((halfBits(card.radius) & 0xfffc) | card.picture) << 16);
}

/** The card at `place` of the draw order. Twin: shaders/forest/card-texel.glsl. */
export function cardTexel(data: Uint32Array, place: number): CardTexel {
  const t = TEXEL * place;
  const [a, b, c, d] = [data[t]!, data[t + 1]!, data[t + 2]!, data[t + 3]!];
  return {
    piece: a & 0x7fffffff,
    odd: a >>> 31 === 1,
    v: (b & 0xffff) / 65535,
    phase: (b >>> 16) / 65535,
    offset: [halfValue(c & 0xffff), halfValue(c >>> 16), halfValue(d & 0xffff)],
    radius: halfValue((d >>> 16) & 0xfffc),
    picture: (d >>> 16) & 3,
  };
}
