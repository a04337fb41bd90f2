import { allowedValues } from '../file/allowed.ts';
import type { Parameter } from '../file/parameter.ts';
import { mayBe, type ParameterValue, PLACES, type SpeciesEdits } from '../species/edits.ts';
import { absentText } from './encode-edits.ts';
import type { LinkReader } from './reader.ts';

const number = (text: string): number => (/^-?\d{1,15}(\.\d{1,15})?$/.test(text) ? Number(text) : Number.NaN);

/** What `editText` wrote; what it may be is the table's affair. */
function textValue(parameter: Parameter, text: string): ParameterValue {
  if (text === absentText(parameter)) return null;
  switch (parameter.kind) {
    case 'number':
      return number(text);
    case 'numbers':
      return text.split(',', 9).map(number);
    case 'flag':
      return text === '1' || text === 'true' ? true : text === '0' || text === 'false' ? false : text;
    case 'colour':
      return text.startsWith('#') ? text : `#${text}`;
    case 'choice':
      return text;
  }
}

/** What may stand behind a key, in the words of a link. */
function allowedText(path: string, p: Parameter): string {
  const orNone = mayBe(path, null) ? `, or ${absentText(p)}` : '';
  switch (p.kind) {
    case 'flag':
      return '0 or 1';
    case 'colour':
      return `a colour as rrggbb${orNone}`;
    case 'choice':
      return p.choices.join(', ') + orNone;
    default:
      return allowedValues(p).replace(', or null', '') + orNone;
  }
}

/** The edits that a link says: `levels.1.downAngle=45`. Each value that is wrong gives a fault and is left out. */
export function decodeEdits(reader: LinkReader): SpeciesEdits {
  const edits: Record<string, ParameterValue> = {};
  for (const [path, { parameter }] of PLACES) {
    const text = reader.take(path);
    if (text === undefined) continue;
    const value = textValue(parameter, text);
    if (mayBe(path, value)) edits[path] = value;
    else reader.fault(path, text, allowedText(path, parameter));
  }
  return edits;
}
