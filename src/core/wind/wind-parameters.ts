import type { ChoiceParameter, FlagParameter, NumberParameter, Parameter, ParameterTable } from '../file/parameter.ts';
import { number as numberOf } from '../file/parameter.ts';
import { DEFAULT_GUST, DEFAULT_WAVE, MOST_GUSTS, MOST_WAVES, SHORTEST_REPEAT, SPRING_LEVELS, STILL } from './wind.ts';

/** Where in a wind file a parameter stands; '' is the file itself. Waves, gusts and the levels of the spring are lists. */
export type WindGroup = '' | 'waves' | 'gusts' | 'profile' | 'spring' | 'spring.levels' | 'sway';

/** A part of a wind file and its parameters; `most` entries of them where it is a list. */
export interface WindPart extends ParameterTable {
  readonly group: WindGroup;
  readonly most?: number;
}

/** What a row says of a number besides its range; `of` is the table of defaults in which it stands. */
type Row = Partial<Pick<NumberParameter, 'unit' | 'symbol' | 'section' | 'orNull'>>;

const common = { symbol: '', section: '', optional: true } as const;

const number = (
  group: WindGroup,
  of: object,
  key: string,
  label: string,
  help: string,
  range: readonly [min: number, max: number, step: number],
  row: Row = {},
): NumberParameter =>
  numberOf<WindGroup>(group, key, label, help, range, { ...row, optional: true, default: defaultIn(of, key) });

/** The number under `key` of an object of defaults. */
function defaultIn(of: object, key: string): number | null {
  const value: unknown = Object.entries(of).find(([name]) => name === key)?.[1];
  return typeof value === 'number' ? value : null;
}

const flag = (
  group: WindGroup,
  key: string,
  label: string,
  help: string,
  value: boolean,
  section = '',
): FlagParameter => ({
  ...common,
  kind: 'flag',
  group,
  key,
  label,
  help,
  section,
  default: value,
});

const choice = (
  group: WindGroup,
  key: string,
  label: string,
  help: string,
  choices: readonly string[],
  value: string,
): ChoiceParameter => ({ ...common, kind: 'choice', group, key, label, help, choices, default: value });

const paper = (section: string, symbol = ''): Row => ({ symbol, section: `Skjermo 2007, ${section}` });
const TOWARDS = 'towards which it travels and pushes: 0 along x, 90 along y.';

const WHOLE: readonly Parameter[] = [
  number('', STILL, 'strength', 'Strength', 'Factor on all of the wind: 0 is still, 1 is as it says.', [0, 1, 0.01]),
  flag(
    '',
    'zeroMean',
    'No mean push',
    'Take its mean from every wave, so that trees sway about their rest and do not lean.',
    STILL.zeroMean,
    'Skjermo 2007, equation 14',
  ),
  number('', STILL, 'stiffness', 'Stiffness', 'Factor on the stiffness of the whole tree.', [0.05, 20, 0.05]),
  choice(
    '',
    'model',
    'Bend',
    "What the force does to a branch: the paper's bend, damped oscillators, or the sway of Weber & Penn 1995.",
    ['direct', 'spring', 'sway'],
    STILL.model,
  ),
  choice(
    '',
    'pose',
    'Pose',
    'Parents of this step, or those of the last step as the paper has them.',
    ['exact', 'lagged'],
    STILL.pose,
  ),
  number(
    '',
    STILL,
    'forceExponent',
    'Exponent of the force',
    'A bend grows with the force to this power; the paper prints 1.8.',
    [0.1, 4, 0.05],
    paper('equation 16', 'p'),
  ),
  number(
    '',
    STILL,
    'lengthExponent',
    'Exponent of the length',
    'A bend falls with the length of a branch to this power; the paper prints 2.',
    [0, 4, 0.05],
    paper('equations 14 and 17', 'm'),
  ),
  flag(
    '',
    'paper',
    'As printed',
    'The printed forms that make sense, for teaching: waves that travel upwind, lengths that are not kept, projected frames.',
    STILL.paper,
    'Skjermo 2007',
  ),
];

const WAVE: readonly Parameter[] = [
  flag('waves', 'on', 'On', 'Whether it blows.', DEFAULT_WAVE.on),
  flag('waves', 'solo', 'Solo', 'Where any wave is solo, only such waves blow.', DEFAULT_WAVE.solo),
  number(
    'waves',
    DEFAULT_WAVE,
    'amplitude',
    'Amplitude',
    'How far its crest pushes the tip of a branch of 3 m that stands across it.',
    [0, 10, 0.005],
    { unit: 'm', ...paper('equation 14', 'A') },
  ),
  number('waves', DEFAULT_WAVE, 'direction', 'Direction', `Direction ${TOWARDS}`, [-360, 360, 1], {
    unit: 'deg',
    ...paper('equation 11', 'D'),
  }),
  number('waves', DEFAULT_WAVE, 'wavelength', 'Wavelength', 'Distance from one crest to the next.', [0.1, 500, 0.5], {
    unit: 'm',
    ...paper('equation 11', 'w'),
  }),
  number('waves', DEFAULT_WAVE, 'speed', 'Speed', 'How fast its crests travel.', [0, 100, 0.1], {
    unit: 'm/s',
    ...paper('equation 11', 'phi'),
  }),
  number(
    'waves',
    DEFAULT_WAVE,
    'sharpness',
    'Sharpness',
    'The larger, the shorter the gust and the longer the lull.',
    [0.1, 40, 0.1],
    paper('equation 14', 'k'),
  ),
  number('waves', DEFAULT_WAVE, 'phase', 'Phase', 'Where in its turn it is at time 0 at the origin.', [0, 1, 0.01], {
    unit: 'turns',
  }),
];

const GUST: readonly Parameter[] = [
  number(
    'gusts',
    DEFAULT_GUST,
    'start',
    'Start',
    'When its front passes the point x, y for the first time.',
    [-3600, 1_000_000, 0.1],
    {
      unit: 's',
    },
  ),
  number('gusts', DEFAULT_GUST, 'x', 'x', 'The point that it passes at its start.', [-10_000, 10_000, 0.5], {
    unit: 'm',
  }),
  number('gusts', DEFAULT_GUST, 'y', 'y', 'The point that it passes at its start.', [-10_000, 10_000, 0.5], {
    unit: 'm',
  }),
  number('gusts', DEFAULT_GUST, 'direction', 'Direction', `Direction ${TOWARDS}`, [-360, 360, 1], { unit: 'deg' }),
  number('gusts', DEFAULT_GUST, 'speed', 'Speed', 'How fast its front travels.', [0.1, 100, 0.1], { unit: 'm/s' }),
  number('gusts', DEFAULT_GUST, 'amplitude', 'Amplitude', 'Its peak, as that of a wave.', [0, 10, 0.005], {
    unit: 'm',
  }),
  number('gusts', DEFAULT_GUST, 'rise', 'Rise', 'Time from the front to the peak.', [0.01, 600, 0.1], { unit: 's' }),
  number('gusts', DEFAULT_GUST, 'fall', 'Fall', 'Time from the peak to nothing.', [0.01, 600, 0.1], { unit: 's' }),
  number(
    'gusts',
    DEFAULT_GUST,
    'width',
    'Width',
    'Width of the front at half its force; 0 is without end.',
    [0, 10_000, 1],
    { unit: 'm' },
  ),
  number(
    'gusts',
    DEFAULT_GUST,
    'repeat',
    'Repeat',
    `Time after which it comes again, for ever, at least ${SHORTEST_REPEAT} and as long as its rise and fall; 0 is once.`,
    [0, 3600, 1],
    { unit: 's' },
  ),
];

const PROFILE: readonly Parameter[] = [
  choice(
    'profile',
    'kind',
    'Profile',
    'How the wind grows with height: not at all, as the paper has it, or by one of two laws.',
    ['none', 'log', 'power'],
    STILL.profile.kind,
  ),
  number(
    'profile',
    STILL.profile,
    'height',
    'Height',
    'Where the wind is as strong as the waves say.',
    [0.1, 1000, 0.5],
    { unit: 'm' },
  ),
  number(
    'profile',
    STILL.profile,
    'roughness',
    'Roughness',
    'Length z0 of the logarithmic law: 0.0002 open sea, 0.03 grass, 0.5 a hedged field, 2 a town; less than the height.',
    [0.0001, 10, 0.01],
    { unit: 'm', symbol: 'z0' },
  ),
  number(
    'profile',
    STILL.profile,
    'exponent',
    'Exponent',
    'Of the power law: 0.1 open sea, 0.15 grass, 0.3 a wood or a town.',
    [0, 1, 0.01],
  ),
];

const SPRING: readonly Parameter[] = [
  number(
    'spring',
    STILL.spring,
    'frequency',
    'Frequency',
    'Factor on the natural frequency of every branch.',
    [0.05, 20, 0.05],
  ),
  number(
    'spring',
    STILL.spring,
    'damping',
    'Damping',
    'Damping ratio of a branch: below 1 it swings, at 1 it comes to rest at once.',
    [0.005, 10, 0.01],
  ),
  number(
    'spring',
    STILL.spring,
    'inertia',
    'Inertia',
    'How much the motion of its parent shakes a branch.',
    [0, 1, 0.05],
  ),
];

const SPRING_LEVEL: readonly Parameter[] = [
  number(
    'spring.levels',
    {},
    'frequency',
    'Frequency',
    'Natural frequency of the branches of this level.',
    [0.05, 20, 0.05],
    { unit: 'Hz', orNull: 'as grown' },
  ),
  number('spring.levels', {}, 'damping', 'Damping', 'Damping ratio of the branches of this level.', [0.005, 10, 0.01], {
    orNull: 'as the whole tree',
  }),
];

const wp = (symbol: string): Row => ({ symbol, section: 'Weber & Penn 1995, 4.7' });

const SWAY: readonly Parameter[] = [
  number('sway', STILL.sway, 'speed', 'Wind speed', "In the paper's own numbers.", [0, 100, 0.5], wp('wind_speed')),
  number('sway', STILL.sway, 'gust', 'Wind gust', "In the paper's own numbers.", [0, 100, 0.5], wp('wind_gust')),
  {
    ...choice(
      'sway',
      'reading',
      'Frequency',
      "What it goes by: the ratio of radius to length as the paper has it, or that of radius to length squared, a cantilever's.",
      ['ratio', 'cantilever'],
      STILL.sway.reading,
    ),
    section: 'Weber & Penn 1995, 4.7',
  },
  number(
    'sway',
    STILL.sway,
    'rate',
    'Rate',
    'Radians a second that a ratio of 1 gives; the paper prints 1/15.',
    [0.001, 10_000, 1],
    { section: 'Weber & Penn 1995, 4.7' },
  ),
];

/** The parameter table of the wind: everything that checks, documents or draws a wind file reads it from here. Angles in degrees. */
export const WIND_PARTS = {
  whole: { group: '', title: 'The whole wind', help: 'At the top of the file.', parameters: WHOLE },
  waves: {
    group: 'waves',
    title: 'Waves',
    help: `A list of up to ${MOST_WAVES} waves that blow without end; the paper has four.`,
    parameters: WAVE,
    most: MOST_WAVES,
  },
  gusts: {
    group: 'gusts',
    title: 'Gusts',
    help: `A list of up to ${MOST_GUSTS} gusts: fronts that each cross the meadow, once or again and again.`,
    parameters: GUST,
    most: MOST_GUSTS,
  },
  profile: { group: 'profile', title: 'Height profile', help: 'How the wind grows with height.', parameters: PROFILE },
  spring: {
    group: 'spring',
    title: 'Spring',
    help: 'The bend model `spring`: every branch is a damped oscillator.',
    parameters: SPRING,
  },
  springLevels: {
    group: 'spring.levels',
    title: 'Spring, level by level',
    help: `A list of up to ${SPRING_LEVELS} levels of stems, the trunk first, whose own oscillation is overridden; null leaves it.`,
    parameters: SPRING_LEVEL,
    most: SPRING_LEVELS,
  },
  sway: { group: 'sway', title: 'Sway', help: 'The bend model `sway` of Weber & Penn 1995.', parameters: SWAY },
} as const satisfies Record<string, WindPart>;
