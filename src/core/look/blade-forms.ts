import type { LeafForm } from './blade.ts';
import { GRASS, HEART, LANCE, MITTEN, SEVEN_LOBES, STRAP, TOOTHED } from './blade-outlines.ts';
import { simple } from './simple-leaf.ts';

/** Leaves of one blade that the paper has not, by `leaves.shape`. */
export const BLADE_FORMS: Readonly<Record<number, LeafForm>> = {
  6: simple(LANCE, 'pinnate', { ribs: [3, 1, 0], bend: { fold: 0.4, arch: 0.3, curl: 0.22 } }),
  7: simple(HEART, 'palmate', { lobes: [[0.47, 0.5]] }),
  8: simple(SEVEN_LOBES, 'palmate', {
    lobes: [
      [0.43, 0.64],
      [0.5, 0.22],
      [0.28, -0.07],
    ],
  }),
  16: simple(STRAP, 'parallel', { ribs: [5, 2, 1], bend: { fold: 0.7, arch: 0, curl: 0.34 } }),
  17: simple(GRASS, 'parallel', { ribs: [5, 2, 1], bend: { fold: 0.5, arch: 0, curl: 0.38 } }),
  18: simple(MITTEN, 'palmate', { lobes: [[0.48, 0.68]] }),
  19: simple(TOOTHED, 'pinnate'),
};
