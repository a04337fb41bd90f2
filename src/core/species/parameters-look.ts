import type { ChoiceParameter, ColourParameter, NumbersParameter, Parameter, ParameterGroup } from './parameter.ts';
import { number } from './parameter.ts';
import { LEAF_SHAPES } from './parameters-leaf.ts';
import { BARK_KINDS, ORGAN_KINDS } from './species.ts';

const colour = (group: ParameterGroup, key: string, label: string, help: string, value?: string): ColourParameter => ({
  kind: 'colour',
  group,
  key,
  label,
  help,
  symbol: '',
  section: '',
  optional: true,
  default: value,
});

const OURS = { optional: true } as const;

export const BARK_PARAMETERS: readonly Parameter[] = [
  {
    kind: 'choice',
    group: 'bark',
    key: 'kind',
    label: 'Bark',
    help: 'Pattern of the bark.',
    choices: BARK_KINDS,
    symbol: '',
    section: '',
    optional: true,
    default: 'furrowed',
  },
  colour('bark', 'colour', 'Bark colour', 'Colour of ridges and smooth bark.', '#7d7263'),
  colour('bark', 'dark', 'Dark of the bark', 'Colour in the depth of furrows and of marks.', '#322c25'),
  number('bark', 'grain', 'Grain', 'Size of the pattern.', [0.005, 5, 0.005], { ...OURS, unit: 'm', default: 0.15 }),
  number('bark', 'roughness', 'Bark roughness', '0 mirrors, 1 is dull.', [0, 1, 0.01], { ...OURS, default: 0.9 }),
  number('bark', 'relief', 'Relief', 'Depth of the pattern.', [0, 1, 0.01], { ...OURS, default: 0.7 }),
  number('bark', 'depth', 'Ridges', 'How far ridges stand out of the stem where one is near.', [0, 0.1, 0.001], {
    ...OURS,
    unit: 'm',
    default: 0,
  }),
  colour(
    'bark',
    'young',
    'Twigs',
    'Colour of twigs, before their bark is old; where there is none, one between the two.',
  ),
  number('bark', 'youngRadius', 'Old from', 'Radius at which the bark of a twig has become old.', [0.002, 1, 0.001], {
    ...OURS,
    unit: 'm',
    default: 0.035,
  }),
  number('bark', 'moss', 'Moss', 'How much moss covers the stem, from the foot and the shaded side on.', [0, 1, 0.01], {
    ...OURS,
    default: 0,
  }),
  colour('bark', 'mossColour', 'Colour of the moss', 'Colour of the moss.', '#68753a'),
  number('bark', 'lichen', 'Lichen', 'How much of the bark lichen covers, in patches.', [0, 1, 0.01], {
    ...OURS,
    default: 0,
  }),
  colour('bark', 'lichenColour', 'Colour of the lichen', 'Colour of the lichen.', '#b4bba4'),
];

export const FOLIAGE_PARAMETERS: readonly Parameter[] = [
  number(
    'foliage',
    'outline',
    'Drawn outline',
    'Outline that is drawn in place of the leaf shape.',
    [0, LEAF_SHAPES.length - 1, 1],
    { ...OURS, integer: true, names: LEAF_SHAPES },
  ),
  {
    kind: 'numbers',
    group: 'foliage',
    key: 'margin',
    label: 'Free outline',
    help: 'Half widths of the blade at even steps from base to tip, in place of a shape; 1 is half the width.',
    unit: '',
    least: 2,
    min: 0,
    max: 1,
    step: 0.01,
    symbol: '',
    section: '',
    optional: true,
    default: undefined,
  },
  number('foliage', 'size', 'Drawn size', 'Size of a drawn blade as a part of the leaf scale.', [0.1, 5, 0.05], {
    ...OURS,
    default: 1,
  }),
  colour('foliage', 'colour', 'Leaf colour', 'Colour of the upper face.', '#5d8a35'),
  colour('foliage', 'under', 'Underside', 'Colour of the lower face.', '#93ab6a'),
  colour('foliage', 'glow', 'Glow', 'Colour of the light that comes through.', '#b5cf4a'),
  number('foliage', 'variation', 'Leaf variation', 'How much the colour differs from leaf to leaf.', [0, 1, 0.01], {
    ...OURS,
    default: 0.25,
  }),
  colour('foliage', 'second', 'Second colour', 'What part of the leaves turn to; where there is none, none do.'),
  number('foliage', 'secondShare', 'Turned', 'Part of the leaves that are on their way to it.', [0, 1, 0.01], {
    ...OURS,
    default: 0,
  }),
  number('foliage', 'roughness', 'Leaf roughness', '0 mirrors, 1 is dull.', [0, 1, 0.01], { ...OURS, default: 0.4 }),
  number(
    'foliage',
    'thickness',
    'Thickness',
    'How much light a blade holds back: 0 glows, 1 is opaque.',
    [0, 1, 0.01],
    {
      ...OURS,
      default: 0.3,
    },
  ),
  number('foliage', 'veins', 'Veins', 'How strongly veins show near by.', [0, 1, 0.01], { ...OURS, default: 0.5 }),
  number('foliage', 'cover', 'In leaf', 'Part of the leaves that are there.', [0, 1, 0.01], { ...OURS, default: 1 }),
];

const organKind = (group: ParameterGroup, key: string, value?: string): ChoiceParameter => ({
  kind: 'choice',
  group,
  key,
  label: 'Bears',
  help: 'What twigs bear besides leaves.',
  choices: ORGAN_KINDS,
  symbol: '',
  section: '',
  optional: true,
  default: value,
});

/** What twigs bear besides leaves. */
export const ORGAN_PARAMETERS: readonly Parameter[] = [
  organKind('organ', 'kind', 'none'),
  number('organ', 'share', 'How many', 'Part of the places of leaves at which one stands.', [0, 1, 0.01], {
    ...OURS,
    default: 0.1,
  }),
  number('organ', 'size', 'Organ size', 'Width of a blossom or fruit, length of a cone or catkin.', [0.002, 1, 0.001], {
    ...OURS,
    unit: 'm',
    default: 0.03,
  }),
  colour('organ', 'colour', 'Organ colour', 'Colour of petals, skin or scales.', '#f4e3e6'),
  colour('organ', 'second', 'Organ middle', 'Colour of their middle, stalk or gaps.', '#b08a4a'),
];

/** What a season changes; each that is absent is as in summer. */
export const seasonParameters = (season: 'spring' | 'autumn' | 'winter'): readonly Parameter[] => [
  number(season, 'cover', 'In leaf', 'Part of the leaves that are there.', [0, 1, 0.01], OURS),
  colour(season, 'colour', 'Leaf colour', 'Colour of the upper face.'),
  colour(season, 'second', 'Second colour', 'What part of the leaves turn to.'),
  number(season, 'secondShare', 'Turned', 'Part of the leaves that are on their way to it.', [0, 1, 0.01], OURS),
  colour(season, 'under', 'Underside', 'Colour of the lower face.'),
  colour(season, 'glow', 'Glow', 'Colour of the light that comes through.'),
  organKind(season, 'organ'),
  number(season, 'organShare', 'How many', 'Part of the places of leaves at which one stands.', [0, 1, 0.01], OURS),
  number(
    season,
    'organSize',
    'Organ size',
    'Width of a blossom or fruit, length of a cone or catkin.',
    [0.002, 1, 0.001],
    {
      ...OURS,
      unit: 'm',
    },
  ),
  colour(season, 'organColour', 'Organ colour', 'Colour of petals, skin or scales.'),
];

const stiffness: NumbersParameter = {
  kind: 'numbers',
  group: 'wind',
  key: 'stiffness',
  label: 'Stiffness',
  help: 'What the bend of the stems of each level is divided by.',
  unit: '',
  min: 0.01,
  max: 1000,
  step: 0.1,
  symbol: '',
  section: '',
  optional: true,
  default: [2, 0.8, 0.9, 1],
};

export const WIND_PARAMETERS: readonly Parameter[] = [
  stiffness,
  number('wind', 'flutter', 'Flutter', 'How far leaves flutter at a force of 1.', [0, 180, 1], {
    ...OURS,
    unit: 'deg',
    default: 20,
  }),
  number('wind', 'flutterRate', 'Rate of flutter', 'How fast leaves flutter.', [0, 20, 0.1], {
    ...OURS,
    unit: 'Hz',
    default: 2.5,
  }),
  number('wind', 'modulus', 'Stiffness of the wood', "Young's modulus of the living wood.", [0.1, 30, 0.1], {
    ...OURS,
    unit: 'GPa',
    default: 6,
  }),
  number('wind', 'density', 'Density of the wood', 'Mass of the living wood with its water.', [100, 1500, 10], {
    ...OURS,
    unit: 'kg/m³',
    default: 850,
  }),
  number('wind', 'leafMass', 'Mass of the leaves', 'Mass of living leaves by their area.', [0, 2, 0.01], {
    ...OURS,
    unit: 'kg/m²',
    default: 0.2,
  }),
  number(
    'wind',
    'damping',
    'Damping',
    'Its damping over that of the wind: friction in the wood, drag of leaves.',
    [0.1, 10, 0.05],
    { ...OURS, default: 1 },
  ),
];
