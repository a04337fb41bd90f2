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

/** A tile of bark, `size` x `size` texels of four bytes: dark 0..255 | slope around | slope along (128 is flat) | height. */
export interface BarkImage {
  readonly size: number;
  readonly data: Uint8Array<ArrayBuffer>;
}

/** Grains (`bark.grain`) that the tile holds along each side: large enough that the eye does not find the repeat. */
export const GRAINS_PER_TILE: Readonly<Record<BarkKind, number>> = {
  smooth: 3,
  furrowed: 6,
  plated: 6,
  peeling: 3,
  stringy: 6,
  palm: 6,
  ribbed: 8,
  noded: 2,
};

/** Kinds whose steps along a stem keep their length on thin stems too: rings of a palm, joints of a cane, areoles. */
export const KEEPS_STEPS: Readonly<Record<BarkKind, boolean>> = {
  smooth: false,
  furrowed: false,
  plated: false,
  peeling: false,
  stringy: false,
  palm: true,
  ribbed: true,
  noded: true,
};

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

/**
 * A tile of bark of the given kind, the same on every machine; `size` texels a side, a power of two.
 *
 * Slopes are those of a relief one tile wide and a fifteenth of a tile deep; the shader scales them.
 */
export function barkImage(kind: BarkKind, size: number): BarkImage {
  const { height, dark } = RELIEFS[kind](size);
  const data = new Uint8Array(size * size * 4);
  const mask = size - 1;
  const depth = size / 15 / 2; // central difference over two texels, in texels of height
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const i = y * size + x;
      const sx = (height[y * size + ((x + 1) & mask)]! - height[y * size + ((x - 1) & mask)]!) * depth;
      const sy = (height[((y + 1) & mask) * size + x]! - height[((y - 1) & mask) * size + x]!) * depth;
      data[i * 4] = Math.round(255 * Math.min(1, Math.max(0, dark[i]!)));
      // Slopes to -1..1 by s / (1 + |s|), so that steep walls keep their direction in eight bits.
      data[i * 4 + 1] = Math.round(127.5 + 127.5 * (sx / (1 + Math.abs(sx))));
      data[i * 4 + 2] = Math.round(127.5 + 127.5 * (sy / (1 + Math.abs(sy))));
      data[i * 4 + 3] = Math.round(255 * Math.min(1, Math.max(0, height[i]!)));
    }
  }
  return { size, data };
}
