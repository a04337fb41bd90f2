import type { ColourParameter, NumbersParameter, Parameter, ParameterGroup } from './parameter.ts';
import { number } from './parameter.ts';
import { LEAF_SHAPES } from './parameters-leaf.ts';

const colour = (group: ParameterGroup, key: string, label: string, help: string, value: string): ColourParameter => ({
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
    choices: ['smooth', 'furrowed', 'plated'],
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
];

export const FOLIAGE_PARAMETERS: readonly Parameter[] = [
  number('foliage', 'outline', 'Drawn outline', 'Outline that is drawn in place of the leaf shape.', [0, 5, 1], {
    ...OURS,
    integer: true,
    names: LEAF_SHAPES,
  }),
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
  number('foliage', 'roughness', 'Leaf roughness', '0 mirrors, 1 is dull.', [0, 1, 0.01], { ...OURS, default: 0.4 }),
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
];
