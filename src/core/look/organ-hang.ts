import type { OrganKind } from '../species/species.ts';

/** How far organs hang down whichever way their twig points, 0..1. */
export const ORGAN_HANG: Readonly<Record<OrganKind, number>> = {
  none: 0,
  blossom: 0.1,
  fruit: 0.9,
  cone: 0.65,
  catkin: 0.92,
};
