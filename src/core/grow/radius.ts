import { power } from './elementary.ts';

/** No stem is thinner at its base than a tenth of a millimetre (row 19). */
export const LEAST_RADIUS = 1e-4;

/** Base radius of a trunk in metres; `scaling` is 0Scale +- 0ScaleV, applied once (Weber & Penn 1995, 4.4; row 17). */
export const trunkRadius = (length: number, ratio: number, scaling: number): number =>
  Math.max(length * ratio * scaling, LEAST_RADIUS);

/** Base radius of any other stem in metres; `limit` is the parent's radius where the stem starts (4.4; row 19). */
export const radiusChild = (
  parentRadius: number,
  length: number,
  parentLength: number,
  ratioPower: number,
  limit: number,
): number => Math.max(Math.min(parentRadius * power(length / parentLength, ratioPower), limit), LEAST_RADIUS);
