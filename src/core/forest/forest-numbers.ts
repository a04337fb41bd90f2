import { LINK_NUMBERS } from '../link/numbers.ts';
import type { NumberRule } from '../link/rule.ts';

const rule = (
  label: string,
  unit: string,
  [min, max]: readonly [number, number],
  decimals: number,
  wraps?: true,
): NumberRule => ({ label, unit, min, max, decimals, ...(wraps && { wraps }) });

const SEED = LINK_NUMBERS.seed;

/** The single numbers of a forest, by key; in links and files alike. */
export const FOREST_NUMBERS = {
  seed: SEED,
  size: rule('size', 'm', [100, 4000], 0),
  count: rule('trees', '', [1, 20_000], 0),
  spacing: rule('spacing', 'm', [1, 100], 1),
  hour: LINK_NUMBERS.hour,
  windSpeed: rule('wind speed', 'm/s', [0, 40], 1),
  windTurn: rule('wind turn', '°', [0, 360], 0, true),
  budget: rule('frame budget', 'ms', [8, 200], 1),
} as const satisfies Record<string, NumberRule>;

export const HILLS_NUMBERS = {
  seed: SEED,
  relief: rule('relief', 'm', [0, 400], 1),
  scale: rule('hill to hill', 'm', [20, 4000], 0),
  octaves: rule('octaves', '', [1, 7], 0),
  rise: rule('rise', 'm', [0, 1000], 1),
  valley: rule('valley', 'm', [0, 1000], 1),
  riseTo: rule('rises to', '°', [0, 360], 0, true),
} as const satisfies Record<string, NumberRule>;

export const MAP_NUMBERS = {
  black: rule('height of black', 'm', [-500, 2000], 1),
  white: rule('height of white', 'm', [-500, 2000], 1),
} as const satisfies Record<string, NumberRule>;

export const CLEARING_NUMBERS = {
  seed: SEED,
  bare: rule('bare', '', [0, 0.9], 2),
  scale: rule('clearing to clearing', 'm', [10, 1000], 0),
} as const satisfies Record<string, NumberRule>;

export const CAMERA_NUMBERS = {
  x: rule('eye x', 'm', [-4000, 4000], 2),
  y: rule('eye y', 'm', [-4000, 4000], 2),
  z: rule('eye z', 'm', [-1000, 8000], 2),
  yaw: rule('yaw', '°', [0, 360], 2, true),
  pitch: rule('pitch', '°', [-90, 90], 2),
} as const satisfies Record<string, NumberRule>;

export const SHARE: NumberRule = rule('share', '', [0, 1], 3);

/** What each part of a habitat may be. */
export const HABITAT_NUMBERS = {
  altitude: rule('altitude', 'm', [-1000, 4000], 1),
  slope: rule('slope', '°', [0, 90], 1),
  wetness: rule('wetness', '', [0, 1], 2),
} as const satisfies Record<string, NumberRule>;

/** Kinds of trees in one mix. */
export const MOST_SPECIES = 8;

/** Letters of a forest's name, and of a picture's. */
export const LONGEST_NAME = 80;
