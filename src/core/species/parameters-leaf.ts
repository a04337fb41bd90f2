import type { FlagParameter, NumberParameter } from './parameter.ts';
import { number } from './parameter.ts';

/** Names of the leaf shapes, in the order of their ids. */
export const LEAF_SHAPES = [
  'oval',
  'triangle',
  'three-lobed oak',
  'three-lobed maple',
  'five-lobed maple',
  'three leaflets',
  'lance',
  'heart',
  'seven-lobed maple',
  'feather of leaflets',
  'hand of leaflets',
  'needle',
  'rosette of needles',
  'bundle of needles',
  'sprig of needles',
  'spray of scales',
  'palm leaflet',
  'grass blade',
  'three-lobed sassafras',
  'toothed oval',
  'seven leaflets',
] as const;

const OWN_ANGLE = { unit: 'deg', optional: true } as const;

export const LEAF_PARAMETERS: readonly NumberParameter[] = [
  number('leaves', 'count', 'Leaves', 'Leaves on a stem of the last level, at most.', [-1000, 10_000, 1], {
    symbol: 'Leaves',
    section: '4.5',
    default: 25,
    negative: 'Below 0 that many stand in a fan at the tip of the stem.',
  }),
  number('leaves', 'shape', 'Leaf shape', 'Outline of the leaf.', [0, LEAF_SHAPES.length - 1, 1], {
    symbol: 'LeafShape',
    section: '4.5',
    integer: true,
    names: LEAF_SHAPES,
    default: 0,
  }),
  number('leaves', 'scale', 'Leaf length', 'Length of the blade.', [0.001, 10, 0.005], {
    symbol: 'LeafScale',
    section: '4.5',
    unit: 'm',
    default: 0.15,
  }),
  number('leaves', 'scaleX', 'Leaf width', 'Width of the blade as a fraction of its length.', [0.01, 10, 0.01], {
    symbol: 'LeafScaleX',
    section: '4.5',
    default: 1,
  }),
  number('leaves', 'petiole', 'Petiole', "Length of the leaf's stalk as a fraction of the blade's.", [0, 5, 0.01], {
    optional: true,
    default: 0.5,
  }),
  number(
    'leaves',
    'bend',
    'Turn to the light',
    'How far leaves turn outwards and upwards: 0 not at all, 1 fully.',
    [0, 1, 0.01],
    {
      section: '4.9',
      optional: true,
      default: 0.3,
    },
  ),
  number(
    'leaves',
    'flat',
    'Flat spray',
    'How far leaves lie in two rows in the plane of their twig and its parent: 0 not at all, 1 fully.',
    [0, 1, 0.01],
    { optional: true, default: undefined },
  ),
  number(
    'leaves',
    'quality',
    'Leaf quality',
    'Factor on the number of leaves; they become smaller so that they cover as much.',
    [0.01, 16, 0.05],
    {
      section: '4.5',
      optional: true,
      default: 1,
    },
  ),
  number(
    'leaves',
    'downAngle',
    'Leaf down angle',
    'Angle between leaf and stem, in place of that of the level after the last.',
    [-360, 360, 1],
    OWN_ANGLE,
  ),
  number(
    'leaves',
    'downAngleV',
    'Leaf down angle, variation',
    'How much that angle differs from leaf to leaf.',
    [-360, 360, 1],
    {
      ...OWN_ANGLE,
      negative: 'Below 0 it runs evenly along the stem.',
    },
  ),
  number(
    'leaves',
    'rotate',
    'Leaf rotation',
    'Angle around the stem from leaf to leaf, in place of that of the level after the last.',
    [-360, 360, 1],
    {
      ...OWN_ANGLE,
      negative: 'Below 0 leaves stand on alternate sides.',
    },
  ),
  number(
    'leaves',
    'rotateV',
    'Leaf rotation, variation',
    'How much that rotation differs from leaf to leaf.',
    [0, 360, 1],
    OWN_ANGLE,
  ),
];

export const PRUNING_PARAMETERS: readonly NumberParameter[] = [
  number(
    'pruning',
    'ratio',
    'Pruning',
    'How much stems are shortened to fit the envelope: 0 not at all, 1 fully.',
    [0, 1, 0.01],
    {
      symbol: 'PruneRatio',
      section: '4.6',
      default: 0,
    },
  ),
  number(
    'pruning',
    'width',
    'Envelope width',
    'Largest radius of the envelope as a fraction of the size.',
    [0, 5, 0.01],
    {
      symbol: 'PruneWidth',
      section: '4.6',
      default: 0.5,
    },
  ),
  number(
    'pruning',
    'widthPeak',
    'Envelope peak',
    'Height of the widest place, from the bottom of the envelope: 0 to 1.',
    [0, 1, 0.01],
    {
      symbol: 'PruneWidthPeak',
      section: '4.6',
      default: 0.5,
    },
  ),
  number(
    'pruning',
    'powerLow',
    'Envelope below',
    'Curve of the envelope below its peak: 1 straight, below 1 full, above 1 hollow.',
    [0, 10, 0.001],
    {
      symbol: 'PrunePowerLow',
      section: '4.6',
      default: 0.5,
    },
  ),
  number(
    'pruning',
    'powerHigh',
    'Envelope above',
    'Curve of the envelope above its peak: 1 straight, below 1 full, above 1 hollow.',
    [0, 10, 0.001],
    {
      symbol: 'PrunePowerHigh',
      section: '4.6',
      default: 0.5,
    },
  ),
];

const flag = (key: string, label: string, help: string, section: string): FlagParameter => ({
  kind: 'flag',
  group: 'switches',
  key,
  label,
  help,
  symbol: '',
  section,
  optional: true,
  default: false,
});

/** Readings of the paper between which a species chooses. */
export const SWITCH_PARAMETERS: readonly (FlagParameter | NumberParameter)[] = [
  flag('paper', 'As printed', 'Take the printed form of every switch below, whatever it says.', '4'),
  flag(
    'branchesAboveBase',
    'All branches above the base',
    'Grow all main branches above the bare base, in place of leaving out its share.',
    '4.3',
  ),
  flag(
    'halveCloning',
    'Clones clone less',
    'Halve the propensity of a stem and its clones to split again at each split.',
    '4.3',
  ),
  flag(
    'paperAttraction',
    'Attraction as printed',
    "Use the printed form of the attraction, which acts about the stem's own x axis.",
    '4.8',
  ),
  flag('pruneBase', 'Prune below the crown', 'Shorten stems that hang below the base of the crown too.', '4.6'),
  number(
    'switches',
    'spread',
    'Divergence',
    'Factor of the divergence at splits: 0.75 as the equation prints it, 1 as the text describes it.',
    [0, 2, 0.05],
    {
      section: '4.2',
      optional: true,
      default: 0.75,
    },
  ),
];
