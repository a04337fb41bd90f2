import type { BarkKind } from '../species/species.ts';

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
