import { MOST_WAVES } from '../wind/wind.ts';
import type { NumberRule, SliderRule } from './rule.ts';

export { allowed, kept, type NumberRule, readNumber, roundTo, type SliderRule, wrap } from './rule.ts';

/** A number of a wave, and how a slider offers it. */
export interface WaveNumber extends SliderRule {
  readonly key: 'amplitude' | 'direction' | 'wavelength' | 'speed' | 'sharpness' | 'phase';
}

/** The numbers of a wave in the order in which a link lists them; angles in degrees here, radians in the document. */
export const WAVE_NUMBERS: readonly WaveNumber[] = [
  {
    key: 'amplitude',
    label: 'amplitude',
    unit: 'm',
    min: 0,
    max: 10,
    decimals: 4,
    slider: { min: 0, max: 1.2, step: 0.005 },
    help: 'How far the crest pushes a branch that stands across it.',
  },
  {
    key: 'direction',
    label: 'direction',
    unit: '°',
    min: 0,
    max: 360,
    decimals: 1,
    wraps: true,
    slider: { min: 0, max: 360, step: 1 },
    help: 'Where the wave travels to, and pushes: 0° to the right of the first view, 90° away from you.',
  },
  {
    key: 'wavelength',
    label: 'wavelength',
    unit: 'm',
    min: 0.1,
    max: 500,
    decimals: 2,
    slider: { min: 0.5, max: 60, step: 0.5 },
    help: 'Distance from one crest to the next.',
  },
  {
    key: 'speed',
    label: 'speed',
    unit: 'm/s',
    min: 0,
    max: 100,
    // More than anybody reads: a wind that loops has speeds of its own (loop.ts).
    decimals: 6,
    slider: { min: 0, max: 20, step: 0.1 },
    help: 'How fast the crests travel.',
  },
  {
    key: 'sharpness',
    label: 'sharpness',
    unit: 'k',
    min: 0.1,
    max: 40,
    decimals: 2,
    slider: { min: 0.2, max: 12, step: 0.1 },
    help: 'The exponent k: the larger, the shorter the gust and the longer the lull.',
  },
  {
    key: 'phase',
    label: 'phase',
    unit: 'turns',
    min: 0,
    max: 1,
    decimals: 6,
    wraps: true,
    slider: { min: 0, max: 1, step: 0.01 },
    help: 'Where in its turn the wave is at time 0.',
  },
];

/** The single numbers of a link, by key. */
export const LINK_NUMBERS = {
  seed: { label: 'seed', unit: '', min: 0, max: 4294967295, decimals: 0 },
  t: { label: 'time', unit: 's', min: 0, max: 1_000_000, decimals: 4 },
  rate: { label: 'rate', unit: '×', min: 0.1, max: 2, decimals: 2 },
  levels: { label: 'levels shown', unit: '', min: 1, max: 9, decimals: 0 },
  strength: { label: 'strength', unit: '', min: 0, max: 1, decimals: 2 },
  p: { label: 'exponent of the force', unit: '', min: 0.1, max: 4, decimals: 2 },
  m: { label: 'exponent of the length', unit: '', min: 0, max: 4, decimals: 2 },
  waves: { label: 'number of waves', unit: '', min: 0, max: MOST_WAVES, decimals: 0 },
  hour: { label: 'hour', unit: 'h', min: 0, max: 24, decimals: 2 },
  probe: { label: 'piece', unit: '', min: 0, max: 4294967295, decimals: 0 },
  at: { label: 'place of the line', unit: '', min: 0, max: 1, decimals: 3 },
} as const satisfies Record<string, NumberRule>;

/** The numbers of `cam`, in its order. */
export const CAMERA_NUMBERS: readonly NumberRule[] = [
  { label: 'azimuth', unit: '°', min: 0, max: 360, decimals: 3, wraps: true },
  { label: 'elevation', unit: '°', min: -90, max: 90, decimals: 3 },
  { label: 'distance', unit: 'm', min: 0.01, max: 10_000, decimals: 3 },
  { label: 'target x', unit: 'm', min: -10_000, max: 10_000, decimals: 3 },
  { label: 'target y', unit: 'm', min: -10_000, max: 10_000, decimals: 3 },
  { label: 'target z', unit: 'm', min: -10_000, max: 10_000, decimals: 3 },
];
