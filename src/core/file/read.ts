import { allowedValues, foundText, isAllowed } from './allowed.ts';
import type { Fault } from './fault.ts';
import { nearest } from './nearest.ts';
import { oneLine } from './one-line.ts';
import type { Parameter } from './parameter.ts';

/** What stands between the braces of a JSON object. */
export type Fields = Readonly<Record<string, unknown>>;

/** How long a text at the head of a file may be, and whether it must be there. */
export interface TextRule {
  readonly longest: number;
  readonly required?: true;
}

/** What a parameter is where the file says nothing of it. */
export interface Absent {
  readonly isRequired: (parameter: Parameter) => boolean;
  readonly defaultOf: (parameter: Parameter) => Parameter['default'];
}

/** The value as an object, or undefined and a fault on the list. */
export function fieldsOf(value: unknown, path: string, faults: Fault[]): Fields | undefined {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Fields;
  faults.push({ path, found: foundText(value), allowed: 'an object' });
  return undefined;
}

/** The value as a list of `least` to `most` entries, or undefined and a fault that asks for `allowed`. */
export function listOf(
  value: unknown,
  [least, most]: readonly [number, number],
  path: string,
  allowed: string,
  faults: Fault[],
): readonly unknown[] | undefined {
  if (Array.isArray(value) && value.length >= least && value.length <= most) return value;
  faults.push({ path, found: foundText(value), allowed });
  return undefined;
}

/**
 * Whether the file says that it is of this format and version; a fault on the list where not. Then the rest is not worth reading: a
 * file of another kind would give a hundred faults that say the same.
 */
export function hasFormat(file: Fields, format: string, faults: Fault[]): boolean {
  if (file.format !== format) faults.push({ path: 'format', found: foundText(file.format), allowed: `"${format}"` });
  else if (file.version !== 1)
    faults.push({ path: 'version', found: foundText(file.version), allowed: '1, the only version so far' });
  else return true;
  return false;
}

/** The texts at the head of a file, '' where one that may be missing is; and `$schema`, which is checked and left out. */
export function readTexts(file: Fields, rules: Readonly<Record<string, TextRule>>, faults: Fault[]) {
  const texts: Record<string, string> = {};
  for (const [key, { longest, required }] of Object.entries(rules)) {
    const text = file[key];
    if (typeof text === 'string' && text.length <= longest && !(required && text.trim() === '')) texts[key] = text;
    else if (text === undefined && !required) texts[key] = '';
    else
      faults.push({
        path: key,
        found: foundText(text),
        allowed: `a text of ${required ? '1' : 'up'} to ${longest} characters`,
      });
  }
  if (file.$schema !== undefined && typeof file.$schema !== 'string')
    faults.push({ path: '$schema', found: foundText(file.$schema), allowed: 'a text, the address of the schema' });
  return texts;
}

/** A fault for every key that is not among `known`, with the one that was meant where that is plain. */
export function unknownKeys(fields: Fields, prefix: string, known: readonly string[], faults: Fault[]): void {
  for (const key of Object.keys(fields)) {
    if (known.includes(key)) continue;
    const near = nearest(key, known);
    faults.push({
      path: `${prefix}${oneLine(key)}`,
      found: 'an unknown key',
      allowed: near ? `"${near}"` : known.join(', '),
    });
  }
}

/** JSON has -0, but what is written anew has not: it would be another file that reads the same. */
const withoutMinus = (value: unknown): unknown =>
  typeof value === 'number' ? value + 0 : Array.isArray(value) ? value.map(withoutMinus) : value;

/** The values of parameters, by key, with what is absent filled in; faults go on the list. `prefix` is '' or ends in a dot. */
export function readParameters(
  parameters: readonly Parameter[],
  fields: Fields,
  prefix: string,
  { isRequired, defaultOf }: Absent,
  faults: Fault[],
): Record<string, unknown> {
  const read: Record<string, unknown> = {};
  for (const p of parameters) {
    // An own key alone: a file's `__proto__` or `toString` is none of the parameters.
    const found = Object.hasOwn(fields, p.key) ? fields[p.key] : undefined;
    if (found === undefined && !isRequired(p)) {
      const value = defaultOf(p);
      if (value !== undefined) read[p.key] = value;
    } else if (isAllowed(p, found)) read[p.key] = withoutMinus(found);
    else faults.push({ path: `${prefix}${p.key}`, found: foundText(found), allowed: allowedValues(p) });
  }
  return read;
}
