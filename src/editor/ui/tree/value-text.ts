import { type ParameterValue, PLACES } from '../../../core/species/edits.ts';
import type { Parameter } from '../../../core/species/parameter.ts';
import { isOfSeason } from '../../../core/species/season.ts';
import { valueWords } from '../../words/value.ts';
import { digits } from '../number-field.ts';

/** Digits that a typed value may have beyond those of the step, as documents keep them. */
const FINER = 2;

const decimals = (step: number): number => String(step).split('.')[1]?.length ?? 0;

/** The unit as it stands behind a number. */
export const unitOf = (parameter: Parameter): string => {
  const unit = 'unit' in parameter ? parameter.unit : '';
  return unit === 'deg' ? '°' : unit;
};

/** A number of a parameter as it is shown: with the digits that it has. */
export const numberText = (value: number, step: number): string => digits(value, step, decimals(step) + FINER);

/** A value as a sentence has it: '60°', '13 m', 'conical', 'on'. */
export function valueText(path: string, value: ParameterValue): string {
  const { parameter } = PLACES.get(path)!;
  if (value === null) {
    if (isOfSeason(path)) return valueWords.asSummer;
    return path === 'foliage.outline' ? valueWords.noOutline : valueWords.absent;
  }
  if (typeof value === 'boolean') return value ? valueWords.yes : valueWords.no;
  if (typeof value === 'string') return value;
  if (typeof value !== 'number')
    return value.map((x) => numberText(x, 'step' in parameter ? parameter.step : 1)).join(', ');
  if (parameter.kind !== 'number') return String(value);
  if (parameter.names) return parameter.names[value] ?? String(value);
  const unit = unitOf(parameter);
  return `${numberText(value, parameter.step)}${unit === '°' ? unit : unit && ` ${unit}`}`;
}
