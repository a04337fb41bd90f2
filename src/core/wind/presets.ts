import type { Wave, Wind } from './wind.ts';

/** One wave: peak in metres, direction in degrees, wavelength in metres, speed in metres a second, sharpness, phase in turns. */
type Row = readonly [
  amplitude: number,
  degrees: number,
  wavelength: number,
  speed: number,
  sharpness: number,
  phase: number,
];

const wave = ([amplitude, degrees, wavelength, speed, sharpness, phase]: Row): Wave => ({
  on: true,
  amplitude,
  direction: (degrees * Math.PI) / 180,
  wavelength,
  speed,
  sharpness,
  phase,
});

const wind = (name: string, strength: number, rows: readonly Row[]): Wind => ({
  name,
  strength,
  waves: rows.map(wave),
  model: 'direct',
  pose: 'exact',
  forceExponent: 1,
  // A cantilever whose radius grows with its length to the power 1.2, as the paper's branches do, bends by an angle that falls with
  // the length to the power 0.6 (equations.md 5.3). With 1, twigs flapped by 60 degrees before a main branch moved by 2.
  lengthExponent: 0.6,
  paper: false,
});

/**
 * The first wave of each is the gust that one sees pass through a crown: long, slow, the strongest. The others are shorter and
 * quicker and come from either side of it, with periods that have no common multiple in sight, so that nothing repeats or moves
 * in unison. Peaks are chosen so that a branch of 1 to 4 m bends by a few degrees in a breeze and by up to 35 in a gale.
 */
const BREEZE: readonly Row[] = [
  [0.07, 15, 34, 4.6, 2.4, 0],
  [0.035, -24, 15, 4.1, 1.8, 0.37],
  [0.022, 52, 8.5, 3.7, 1.6, 0.71],
  [0.015, -63, 6, 4.3, 1.5, 0.18],
];

/** The winds to choose from, by name, from weakest to strongest. */
export const presets: Readonly<Record<string, Wind>> = {
  still: wind('still', 0, BREEZE),
  'light-air': wind('light-air', 1, [
    [0.022, 15, 26, 2.2, 2.2, 0],
    [0.013, -28, 13, 2.3, 1.8, 0.37],
    [0.009, 58, 8, 2.1, 1.6, 0.71],
    [0.006, -70, 6, 2.5, 1.5, 0.18],
  ]),
  breeze: wind('breeze', 1, BREEZE),
  'fresh-breeze': wind('fresh-breeze', 1, [
    [0.115, 15, 45, 8.5, 2.4, 0],
    [0.055, -21, 19, 6.8, 2, 0.37],
    [0.032, 44, 10, 5.7, 1.7, 0.71],
    [0.02, -55, 7, 6.6, 1.5, 0.18],
  ]),
  gale: wind('gale', 1, [
    [0.22, 15, 60, 14.5, 2, 0],
    [0.1, -16, 26, 12, 1.8, 0.37],
    [0.055, 34, 13, 9.4, 1.6, 0.71],
    [0.035, -42, 8, 10.3, 1.5, 0.18],
  ]),
};

/** Name of the wind that blows unless another is asked for. */
export const DEFAULT_WIND = 'breeze';
