import type { LeafForm } from './blade.ts';
import type { BladeOutline } from './leaf-outline.ts';
import { PAPER_OUTLINES } from './paper-outlines.ts';
import { simple } from './simple-leaf.ts';

const [OVAL, TRIANGLE, OAK, MAPLE_3, MAPLE_5] = PAPER_OUTLINES as [
  BladeOutline,
  BladeOutline,
  BladeOutline,
  BladeOutline,
  BladeOutline,
];

/** Leaves of Weber & Penn's paper, by `leaves.shape`. */
export const PAPER_FORMS: Readonly<Record<number, LeafForm>> = {
  0: simple(OVAL, 'pinnate'),
  1: simple(TRIANGLE, 'pinnate'),
  2: simple(OAK, 'pinnate'),
  3: simple(MAPLE_3, 'palmate', { lobes: [[0.5, 0.62]] }),
  4: simple(MAPLE_5, 'palmate', {
    lobes: [
      [0.5, 0.58],
      [0.38, 0.02],
    ],
  }),
};
