import { choiceOf, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { treeStage } from '../tree-stage.ts';

const MODES = { leaves: 'shaded', shaded: 'shaded', wireframe: 'wireframe', control: 'control' } as const;

const modeOf = (values: Values) => MODES[choiceOf(values, 'look') as keyof typeof MODES];

export const TREE_FIGURE: FigureSpec = {
  id: 'tree',
  title: 'The shader at work',
  aspect: 1.4,
  controls: [
    {
      id: 'look',
      label: 'Look at',
      options: [
        { value: 'leaves', label: 'bark and leaves' },
        { value: 'shaded', label: 'the bark' },
        { value: 'wireframe', label: 'the sheets' },
        { value: 'control', label: 'the points' },
      ],
      value: 'leaves',
    },
    { id: 'levels', label: 'Levels of stems', min: 1, max: 3, step: 1, value: 3 },
  ],
  readouts: [
    { id: 'pieces', label: 'Curves' },
    { id: 'points', label: 'Control points in the textures' },
    { id: 'bytes', label: 'For all that the wind moves', unit: 'kB' },
  ],
  moves: true,
  begin: 4,
  open: (values) => `s=quaking-aspen&seed=1&view=${modeOf(values)}`,
  stage: treeStage({
    show: (values) => ({
      species: 'quaking-aspen',
      wind: 'fresh-breeze',
      levels: numberOf(values, 'levels'),
      leaves: choiceOf(values, 'look') === 'leaves',
      mode: modeOf(values),
    }),
    readouts: ({ grown }) => {
      const { pieceCount } = grown.packed;
      return {
        pieces: pieceCount,
        points: 4 * pieceCount,
        // Four texels of four numbers of four bytes a curve, in two sets.
        bytes: ((pieceCount * 4 * 4 * 4 * 2) / 1000).toFixed(0),
      };
    },
    text: (values, grown) =>
      grown ? `An aspen of ${grown.packed.pieceCount} curves in a fresh breeze, drawn as ${modeOf(values)}.` : '',
  }),
};
