import { number as numberOf } from '../file/parameter.ts';

export type {
  ChoiceParameter,
  ColourParameter,
  FlagParameter,
  NumberParameter,
  NumbersParameter,
  Parameter,
} from '../file/parameter.ts';

/** Where in a species file a parameter stands. `levels` is a list, one entry a level. */
export type ParameterGroup =
  | 'tree'
  | 'levels'
  | 'leaves'
  | 'pruning'
  | 'switches'
  | 'bark'
  | 'foliage'
  | 'organ'
  | 'spring'
  | 'autumn'
  | 'winter'
  | 'wind';

/** A row of the table: a number from `min` to `max` in a group of a species. */
export const number = numberOf<ParameterGroup>;
