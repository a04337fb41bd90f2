import type { BarkKind } from '../species/species.ts';
import { furrowed } from './bark-furrowed.ts';
import { noded } from './bark-noded.ts';
import { palm } from './bark-palm.ts';
import { peeling } from './bark-peeling.ts';
import { plated } from './bark-plated.ts';
import type { Relief } from './bark-relief.ts';
import { ribbed } from './bark-ribbed.ts';
import { smooth } from './bark-smooth.ts';
import { stringy } from './bark-stringy.ts';
import { type BarkImage, reliefImage } from './relief-image.ts';

export type { BarkImage } from './relief-image.ts';

const RELIEFS: Readonly<Record<BarkKind, (size: number) => Relief>> = {
  smooth,
  furrowed,
  plated,
  peeling,
  stringy,
  palm,
  ribbed,
  noded,
};

/** A tile of bark of the given kind, the same on every machine; `size` texels a side, a power of two. */
export const barkImage = (kind: BarkKind, size: number): BarkImage => reliefImage(RELIEFS[kind](size), size);
