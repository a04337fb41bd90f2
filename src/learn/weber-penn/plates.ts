import { choiceOf, type FigureSpec, numberOf, switchOf } from '../figure.ts';
import { treeStage } from '../tree-stage.ts';
import { editorLink } from './changed-species.ts';

/** The four trees of the paper's plates. */
export const PLATES = [
  { value: 'quaking-aspen', label: 'Quaking aspen' },
  { value: 'black-tupelo', label: 'Black tupelo' },
  { value: 'weeping-willow', label: 'Weeping willow' },
  { value: 'california-black-oak', label: 'California black oak' },
] as const;

/** The paper's trees, grown and in the wind, level by level. */
export const plates: FigureSpec = {
  id: 'plates',
  title: 'One tree, level by level',
  aspect: 1.05,
  moves: true,
  controls: [
    { id: 'species', label: 'Species', options: PLATES, value: 'quaking-aspen' },
    { id: 'levels', label: 'Levels shown (5: and leaves)', min: 1, max: 5, step: 1, value: 5 },
    { id: 'colours', label: 'Colour stems by level', value: false },
  ],
  readouts: [
    { id: 'level0', label: 'Level 0, trunk' },
    { id: 'level1', label: 'Level 1' },
    { id: 'level2', label: 'Level 2' },
    { id: 'level3', label: 'Level 3' },
    { id: 'leaves', label: 'Leaves' },
  ],
  open: (values) => editorLink(choiceOf(values, 'species')),
  stage: treeStage({
    pixels: 1,
    place: 'meadow',
    show: (values) => ({
      species: choiceOf(values, 'species'),
      seed: 1,
      wind: 'breeze',
      levels: numberOf(values, 'levels'),
      leaves: numberOf(values, 'levels') === 5,
      mode: switchOf(values, 'colours') ? 'levels' : 'shaded',
    }),
    readouts: ({ grown }, values) => {
      const shown = numberOf(values, 'levels');
      const stems = Object.fromEntries(
        grown.stats.levels.map(({ level, stems, clones }) => [
          `level${level}`,
          level < shown
            ? `${stems.toLocaleString('en')}${clones > 0 ? ` + ${clones.toLocaleString('en')} clones` : ''}`
            : '–',
        ]),
      );
      return { ...stems, leaves: grown.stats.leaves.toLocaleString('en') };
    },
    text: (values, grown) =>
      grown
        ? `A ${grown.stats.species} of ${grown.stats.height.toFixed(0)} metres with ${numberOf(values, 'levels') === 5 ? 'all its stems and leaves' : `${numberOf(values, 'levels')} levels of stems`} shown.`
        : '',
  }),
};
