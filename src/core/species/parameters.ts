import type { Parameter, ParameterGroup } from './parameter.ts';
import { LEAF_PARAMETERS, PRUNING_PARAMETERS, SWITCH_PARAMETERS } from './parameters-leaf.ts';
import { LEVEL_PARAMETERS } from './parameters-level.ts';
import {
  BARK_PARAMETERS,
  FOLIAGE_PARAMETERS,
  ORGAN_PARAMETERS,
  seasonParameters,
  WIND_PARAMETERS,
} from './parameters-look.ts';
import { TREE_PARAMETERS } from './parameters-tree.ts';

/** A part of a species file and its parameters. */
export interface Group {
  readonly group: ParameterGroup;
  readonly title: string;
  readonly help: string;
  readonly parameters: readonly Parameter[];
}

/** The parameter table: everything that checks, documents or draws a species reads it from here. */
export const GROUPS: readonly Group[] = [
  { group: 'tree', title: 'Tree', help: 'The whole tree.', parameters: TREE_PARAMETERS },
  {
    group: 'levels',
    title: 'Levels',
    help: 'A list with an entry for each level of stems: the trunk, main branches, and smaller ones. Deeper levels than the list has use its last.',
    parameters: LEVEL_PARAMETERS,
  },
  { group: 'leaves', title: 'Leaves', help: 'Leaves on the stems of the last level.', parameters: LEAF_PARAMETERS },
  {
    group: 'pruning',
    title: 'Pruning',
    help: 'The envelope that stems are shortened to.',
    parameters: PRUNING_PARAMETERS,
  },
  {
    group: 'switches',
    title: 'Readings',
    help: 'Where the paper can be read in two ways.',
    parameters: SWITCH_PARAMETERS,
  },
  { group: 'bark', title: 'Bark', help: 'How the stems look.', parameters: BARK_PARAMETERS },
  { group: 'foliage', title: 'Foliage', help: 'How the leaves look.', parameters: FOLIAGE_PARAMETERS },
  { group: 'organ', title: 'Blossom and fruit', help: 'What twigs bear besides leaves.', parameters: ORGAN_PARAMETERS },
  {
    group: 'spring',
    title: 'Spring',
    help: 'What spring changes of the look.',
    parameters: seasonParameters('spring'),
  },
  {
    group: 'autumn',
    title: 'Autumn',
    help: 'What autumn changes of the look.',
    parameters: seasonParameters('autumn'),
  },
  {
    group: 'winter',
    title: 'Winter',
    help: 'What winter changes of the look.',
    parameters: seasonParameters('winter'),
  },
  { group: 'wind', title: 'Wind', help: 'How the tree answers the wind.', parameters: WIND_PARAMETERS },
];

/** All parameters, group by group. */
export const PARAMETERS: readonly Parameter[] = GROUPS.flatMap((group) => group.parameters);

/** The most levels that a file lists; deeper ones use the last (weber-penn.md, row 51). */
export const MOST_LEVELS = 4;

/** Whether a file must have the parameter, at this level where it is one of a level. */
export function isRequired(parameter: Parameter, level = 0): boolean {
  if (parameter.optional) return false;
  if (parameter.levels === 'trunk') return level === 0;
  return parameter.levels === 'branches' ? level > 0 : true;
}

/** The value of a parameter that a file leaves out; undefined where it then stays absent. */
export function defaultOf(parameter: Parameter, level = 0): Parameter['default'] {
  // A species that says nothing of its trunks has one.
  return parameter.group === 'levels' && parameter.key === 'branches' && level === 0 ? 1 : parameter.default;
}
