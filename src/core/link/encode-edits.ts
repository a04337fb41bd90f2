import type { Parameter } from '../file/parameter.ts';
import { type ParameterValue, PLACES, type SpeciesEdits } from '../species/edits.ts';
import { roundValue } from '../species/round-value.ts';

/** `null` in a link. */
const NONE = 'none';
/** The same where `none` is one of the choices: what is not said is not the same as that there is none. */
const UNSAID = '-';

/** How a link says that a parameter is absent. */
export const absentText = (parameter: Parameter): string =>
  parameter.kind === 'choice' && parameter.choices.includes(NONE) ? UNSAID : NONE;

/** The edits as a link gives them back: rounded, in the order of the table; paths of no parameter are left out. */
export function roundEdits(edits: SpeciesEdits): SpeciesEdits {
  if (Object.keys(edits).length === 0) return edits;
  const rounded: Record<string, ParameterValue> = {};
  for (const [path, { parameter }] of PLACES) {
    if (Object.hasOwn(edits, path)) rounded[path] = roundValue(parameter, edits[path]!);
  }
  return rounded;
}

/** An edit as the value of a link's key: `45`, `abc123` for a colour, `2,0.8,1`, `0` or `1`, `none`. */
export function editText(path: string, value: ParameterValue): string {
  if (value === null) return absentText(PLACES.get(path)!.parameter);
  if (typeof value === 'boolean') return value ? '1' : '0';
  return typeof value === 'string' ? value.replace(/^#/, '') : String(value);
}
