import { SHAPES } from '../grow/shape-names.ts';
import type { NumberParameter, NumbersParameter } from './parameter.ts';
import { number } from './parameter.ts';

const crown: NumbersParameter = {
  kind: 'numbers',
  group: 'tree',
  key: 'crown',
  label: 'Crown curve',
  help: 'Lengths of the main branches from the base of the crown to its top, in place of the shape.',
  unit: '',
  min: 0,
  max: 1,
  step: 0.01,
  least: 2,
  symbol: '',
  section: '',
  optional: true,
  default: undefined,
};

/** Parameters of the whole tree. */
export const TREE_PARAMETERS: readonly (NumberParameter | NumbersParameter)[] = [
  number(
    'tree',
    'shape',
    'Shape',
    'How the length of the main branches runs over the height of the crown.',
    [0, 9, 1],
    {
      symbol: 'Shape',
      section: '4.3',
      integer: true,
      names: SHAPES,
      default: 7,
    },
  ),
  crown,
  number('tree', 'baseSize', 'Bare base', 'Part of the trunk at its base that bears no branches.', [0, 0.99, 0.01], {
    symbol: 'BaseSize',
    section: '4.3',
    default: 0.2,
  }),
  number('tree', 'scale', 'Size', 'Size of the tree: about its height.', [0.05, 150, 0.1], {
    symbol: 'Scale',
    section: '4.3',
    unit: 'm',
    default: 13,
  }),
  number(
    'tree',
    'scaleV',
    'Size, variation',
    'How much the size differs from tree to tree, up and down.',
    [0, 150, 0.1],
    {
      symbol: 'ScaleV',
      section: '4.3',
      unit: 'm',
      default: 0,
    },
  ),
  number('tree', 'zScale', 'Stretch', 'Factor that stretches the finished tree along its height.', [0.1, 10, 0.01], {
    symbol: 'ZScale',
    section: 'appendix',
    default: 1,
  }),
  number('tree', 'zScaleV', 'Stretch, variation', 'How much the stretch differs from tree to tree.', [0, 5, 0.01], {
    symbol: 'ZScaleV',
    section: 'appendix',
    default: 0,
  }),
  number(
    'tree',
    'levels',
    'Levels',
    'Levels of stems: 1 is a bare trunk, 3 or 4 are usual; leaves grow on the last.',
    [1, 8, 1],
    {
      symbol: 'Levels',
      section: '4.5',
      integer: true,
      default: 3,
    },
  ),
  number('tree', 'ratio', 'Thickness', 'Radius of the trunk as a fraction of its length.', [0, 1, 0.001], {
    symbol: 'Ratio',
    section: '4.4',
    default: 0.015,
  }),
  number(
    'tree',
    'ratioPower',
    'Thinning',
    'How much faster than their length the radius of children falls.',
    [0, 10, 0.05],
    {
      symbol: 'RatioPower',
      section: '4.4',
      default: 1.2,
    },
  ),
  number('tree', 'lobes', 'Lobes', 'Ridges around the trunk.', [0, 64, 1], {
    symbol: 'Lobes',
    section: '4.4',
    integer: true,
    default: 0,
  }),
  number('tree', 'lobeDepth', 'Depth of lobes', 'Depth of the ridges as a fraction of the radius.', [0, 0.95, 0.01], {
    symbol: 'LobeDepth',
    section: '4.4',
    default: 0,
  }),
  number(
    'tree',
    'flare',
    'Flare',
    'How much wider the trunk becomes at the ground, as a fraction of its radius.',
    [0, 10, 0.05],
    {
      symbol: 'Flare',
      section: '4.4',
      default: 0.5,
    },
  ),
  number(
    'tree',
    'attractionUp',
    'Attraction up',
    'How much stems from level 2 on turn upwards; 1 ends them upright.',
    [-10, 10, 0.05],
    {
      symbol: 'AttractionUp',
      section: '4.8',
      default: 0.5,
      negative: 'Below 0 they droop.',
    },
  ),
  number(
    'tree',
    'disc',
    'Disc of trunks',
    'Radius of the disc in which several trunks stand, as a fraction of the size.',
    [0, 2, 0.01],
    {
      optional: true,
      default: 0.05,
    },
  ),
  number('tree', 'bulges', 'Bulges', 'Swellings along every stem (Skjermo 2006, equation 4).', [0, 200, 1], {
    optional: true,
    default: 0,
  }),
  number(
    'tree',
    'bulgeDepth',
    'Depth of bulges',
    'Depth of the swellings as a fraction of the radius.',
    [0, 0.95, 0.01],
    {
      optional: true,
      default: 0,
    },
  ),
];
