/** What a number of a document may be: its unit, its range, and the digits that a link keeps of it. */
export interface NumberRule {
  /** Name to show, lower case. */
  readonly label: string;
  /** Symbol of the unit, empty for a bare number. */
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  /** Digits after the point, in the link and so in the document. */
  readonly decimals: number;
  /** `max` is the same as `min`: a turn. */
  readonly wraps?: true;
}

/** A number of a wave, and how a slider offers it. */
export interface WaveNumber extends NumberRule {
  readonly key: 'amplitude' | 'direction' | 'wavelength' | 'speed' | 'sharpness' | 'phase';
  /** What a slider reaches and the step of its arrow keys; typing reaches `max`. */
  readonly slider: { readonly min: number; readonly max: number; readonly step: number };
  /** One sentence. */
  readonly help: string;
}

/** The numbers of a wave in the order in which a link lists them; angles in degrees here, radians in the document. */
export const WAVE_NUMBERS: readonly WaveNumber[] = [
  {
    key: 'amplitude',
    label: 'amplitude',
    unit: 'm',
    min: 0,
    max: 10,
    decimals: 3,
    slider: { min: 0, max: 0.4, step: 0.005 },
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
    decimals: 2,
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

/** `value` with the digits that a link keeps, inside the range; never -0. */
export function roundTo(rule: NumberRule, value: number): number {
  const inside = Math.min(rule.max, Math.max(rule.min, value));
  return Number(inside.toFixed(rule.decimals)) + 0;
}

/** `value` with the digits that a link keeps, in [0, max) of a rule that wraps. */
export function wrap(rule: NumberRule, value: number): number {
  return roundTo(rule, ((value % rule.max) + rule.max) % rule.max) % rule.max;
}

/** The number that `text` is by the rule, or undefined: plain decimal digits alone, within the range. */
export function readNumber(rule: NumberRule, text: string): number | undefined {
  const pattern = rule.decimals === 0 ? /^-?\d{1,15}$/ : /^-?\d{1,15}(\.\d{1,15})?$/;
  if (!pattern.test(text)) return undefined;
  const value = Number(text);
  return value < rule.min || value > rule.max ? undefined : roundTo(rule, value);
}

/** What the rule allows, in words: `a number from 0 to 10 m`. */
export function allowed(rule: NumberRule): string {
  const unit = rule.unit && rule.unit !== 'k' ? ` ${rule.unit}` : '';
  return `a ${rule.decimals === 0 ? 'whole number' : 'number'} from ${rule.min} to ${rule.max}${unit}`;
}
