import { WIND_PARTS } from '../wind/wind-parameters.ts';
import type { SliderRule } from './rule.ts';

/** What a wind file may say of a number: the same holds everywhere. */
function limits(part: keyof typeof WIND_PARTS, key: string): { min: number; max: number } {
  const found = WIND_PARTS[part].parameters.find((p) => p.key === key);
  if (found?.kind !== 'number') throw new Error(`${part} has no number ${key}`);
  return { min: found.min, max: found.max };
}

/** The numbers of a gust in the order in which a link lists them; angles in degrees here, radians in the document. */
export interface GustNumber extends SliderRule {
  readonly key: 'start' | 'x' | 'y' | 'direction' | 'speed' | 'amplitude' | 'rise' | 'fall' | 'width' | 'repeat';
}

export const GUST_NUMBERS: readonly GustNumber[] = [
  {
    key: 'start',
    label: 'start',
    unit: 's',
    ...limits('gusts', 'start'),
    decimals: 2,
    slider: { min: 0, max: 60, step: 0.1 },
    help: 'When the front passes the place where it begins.',
  },
  {
    key: 'x',
    label: 'place, right',
    unit: 'm',
    ...limits('gusts', 'x'),
    decimals: 2,
    slider: { min: -40, max: 40, step: 0.5 },
    help: 'Where it begins: metres to the right of the tree in the first view.',
  },
  {
    key: 'y',
    label: 'place, away',
    unit: 'm',
    ...limits('gusts', 'y'),
    decimals: 2,
    slider: { min: -40, max: 40, step: 0.5 },
    help: 'Where it begins: metres behind the tree in the first view.',
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
    help: 'Where the front travels to, and pushes: 0° to the right of the first view, 90° away from you.',
  },
  {
    key: 'speed',
    label: 'speed',
    unit: 'm/s',
    ...limits('gusts', 'speed'),
    decimals: 2,
    slider: { min: 1, max: 30, step: 0.5 },
    help: 'How fast the front crosses the meadow.',
  },
  {
    key: 'amplitude',
    label: 'amplitude',
    unit: 'm',
    ...limits('gusts', 'amplitude'),
    decimals: 4,
    slider: { min: 0, max: 1.8, step: 0.005 },
    help: 'How far its peak pushes a branch that stands across it.',
  },
  {
    key: 'rise',
    label: 'rise',
    unit: 's',
    ...limits('gusts', 'rise'),
    decimals: 2,
    slider: { min: 0.1, max: 6, step: 0.1 },
    help: 'From the front to the peak.',
  },
  {
    key: 'fall',
    label: 'fall',
    unit: 's',
    ...limits('gusts', 'fall'),
    decimals: 2,
    slider: { min: 0.1, max: 12, step: 0.1 },
    help: 'From the peak to nothing.',
  },
  {
    key: 'width',
    label: 'width',
    unit: 'm',
    ...limits('gusts', 'width'),
    decimals: 2,
    slider: { min: 0, max: 60, step: 1 },
    help: 'Half as strong at this width; 0 is a front without end.',
  },
  {
    key: 'repeat',
    label: 'repeat',
    unit: 's',
    ...limits('gusts', 'repeat'),
    decimals: 2,
    slider: { min: 0, max: 180, step: 1 },
    help: 'After how long it comes again, for ever; 0 is once, anything else at least 5 s, and its rise and fall.',
  },
];

/** The single numbers of a wind that are no wave's and no gust's. */
export const WIND_NUMBERS = {
  stiffness: {
    label: 'stiffness',
    unit: '×',
    ...limits('whole', 'stiffness'),
    decimals: 3,
    slider: { min: 0.2, max: 4, step: 0.05 },
    help: 'A factor on the stiffness of the whole tree: 2 bends half as far.',
  },
  height: {
    label: 'height',
    unit: 'm',
    ...limits('profile', 'height'),
    decimals: 2,
    slider: { min: 1, max: 40, step: 0.5 },
    help: 'Where the wind is as strong as its waves say.',
  },
  roughness: {
    label: 'roughness',
    unit: 'm',
    ...limits('profile', 'roughness'),
    decimals: 4,
    slider: { min: 0.001, max: 1, step: 0.001 },
    help: 'Roughness length z0: 0.01 m on a lawn, 0.1 m over bushes, 1 m in a town.',
  },
  exponent: {
    label: 'exponent',
    unit: '',
    ...limits('profile', 'exponent'),
    decimals: 3,
    slider: { min: 0, max: 0.6, step: 0.01 },
    help: 'About 0.14 over open water and 0.3 in a wood.',
  },
  frequency: {
    label: 'frequency',
    unit: '×',
    ...limits('spring', 'frequency'),
    decimals: 3,
    slider: { min: 0.2, max: 4, step: 0.05 },
    help: 'A factor on how fast each branch swings by itself.',
  },
  damping: {
    label: 'damping',
    unit: 'ζ',
    ...limits('spring', 'damping'),
    decimals: 3,
    slider: { min: 0.01, max: 1.2, step: 0.01 },
    help: 'How soon a swing dies: 0.05 rings for long, 1 does not swing at all.',
  },
  inertia: {
    label: 'inertia',
    unit: '',
    ...limits('spring', 'inertia'),
    decimals: 3,
    slider: { min: 0, max: 1, step: 0.01 },
    help: 'How much of its parent’s acceleration shakes a branch.',
  },
  hertz: {
    label: 'frequency',
    unit: 'Hz',
    ...limits('springLevels', 'frequency'),
    decimals: 3,
    slider: { min: 0.1, max: 5, step: 0.05 },
    help: 'Natural frequency of the branches of this level, in place of the one that they grew with.',
  },
  swaySpeed: {
    label: 'wind speed',
    unit: '',
    ...limits('sway', 'speed'),
    decimals: 2,
    slider: { min: 0, max: 50, step: 0.5 },
    help: 'The paper’s wind speed, 0 to 50.',
  },
  swayGust: {
    label: 'wind gust',
    unit: '',
    ...limits('sway', 'gust'),
    decimals: 2,
    slider: { min: 0, max: 50, step: 0.5 },
    help: 'The paper’s gust: a second, slower swing on top of the first.',
  },
  rate: {
    label: 'rate',
    unit: '1/s',
    ...limits('sway', 'rate'),
    decimals: 4,
    slider: { min: 1, max: 200, step: 1 },
    help: 'Radians a second at a ratio of 1; the paper prints 1/15, which hardly moves.',
  },
} as const satisfies Record<string, SliderRule>;

/** The numbers of `profile`, `spring` and `sway` in the order in which a link lists them. */
export const PROFILE_NUMBERS = [WIND_NUMBERS.height, WIND_NUMBERS.roughness, WIND_NUMBERS.exponent] as const;
export const SPRING_NUMBERS = [WIND_NUMBERS.frequency, WIND_NUMBERS.damping, WIND_NUMBERS.inertia] as const;
export const SWAY_NUMBERS = [WIND_NUMBERS.swaySpeed, WIND_NUMBERS.swayGust, WIND_NUMBERS.rate] as const;
