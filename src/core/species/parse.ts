import { allowedValues, foundText, isAllowed } from './allowed.ts';
import { jsonFault } from './json-fault.ts';
import { nearest } from './nearest.ts';
import { oneLine } from './one-line.ts';
import type { Parameter } from './parameter.ts';
import type { Group } from './parameters.ts';
import { defaultOf, GROUPS, isRequired, MOST_LEVELS } from './parameters.ts';
import type { Species } from './species.ts';

/** One thing that is wrong with a species file. All three are plain text, never markup. */
export interface Fault {
  /** Where in the file: 'levels[2].curveRes'; '' for the file as a whole. */
  readonly path: string;
  /** What stands there. */
  readonly found: string;
  /** What may stand there. */
  readonly allowed: string;
}

export type ParsedSpecies =
  | { readonly species: Species; readonly faults?: undefined }
  | { readonly species?: undefined; readonly faults: readonly Fault[] };

/** A fault on one line. */
export const faultText = ({ path, found, allowed }: Fault): string =>
  `${path === '' ? 'The file' : path}: found ${found}; allowed: ${allowed}.`;

/** A species file is a few kilobytes; this much is something else. */
const LONGEST = 1_000_000;

/** The texts at the head of a file, with the most characters they may have. */
const TEXTS = { name: 80, latin: 80, source: 400 } as const;

type Fields = Readonly<Record<string, unknown>>;

/**
 * A species from the text of a file, or from what JSON.parse made of it; every fault where there are any, each with its path.
 *
 * The paper's parameters must all be there. Windgrove's own may be left out and are filled in from the parameter table. Never throws.
 */
export function parseSpecies(file: unknown): ParsedSpecies {
  if (typeof file !== 'string') return readSpecies(file);
  // Some editors begin a file with a byte order mark; a browser takes it off as it reads, Node does not.
  const input = file.replace(/^\ufeff/, '');
  const broken = (found: string): ParsedSpecies => ({
    faults: [{ path: '', found, allowed: 'a species as a JSON document' }],
  });
  if (input.trim() === '') return broken('an empty file');
  if (input.length > LONGEST) return broken(`${input.length} characters`);
  let value: unknown;
  try {
    value = JSON.parse(input);
  } catch {
    return broken(`broken JSON ${placeOf(jsonFault(input), input)}`);
  }
  return readSpecies(value);
}

function placeOf(index: number, text: string): string {
  const before = text.slice(0, index).split('\n');
  const place = `at line ${before.length}, column ${before[before.length - 1].length + 1}`;
  return index === text.length ? `that ends too early, ${place}` : place;
}

function readSpecies(value: unknown): ParsedSpecies {
  const faults: Fault[] = [];
  const file = fieldsOf(value, '', faults);
  if (!file) return { faults };
  if (file.format !== 'windgrove-species') {
    faults.push({ path: 'format', found: foundText(file.format), allowed: '"windgrove-species"' });
  } else if (file.version !== 1) {
    faults.push({ path: 'version', found: foundText(file.version), allowed: '1, the only version so far' });
  }
  // A file of another kind would give a hundred faults that say the same.
  if (faults.length > 0) return { faults };

  const groupNames = GROUPS.map((group) => group.group);
  unknownKeys(file, '', ['format', 'version', ...Object.keys(TEXTS), ...groupNames, '$schema'], faults);
  const species: Record<string, unknown> = { format: 'windgrove-species', version: 1 };
  for (const [key, longest] of Object.entries(TEXTS)) {
    const text = file[key];
    if (typeof text === 'string' && text.length <= longest && (key !== 'name' || text.trim() !== ''))
      species[key] = text;
    else if (text === undefined && key !== 'name') species[key] = '';
    else
      faults.push({
        path: key,
        found: foundText(text),
        allowed: `a text of ${key === 'name' ? '1' : 'up'} to ${longest} characters`,
      });
  }
  if (file.$schema !== undefined && typeof file.$schema !== 'string')
    faults.push({ path: '$schema', found: foundText(file.$schema), allowed: 'a text, the address of the schema' });
  for (const group of GROUPS) {
    const content = file[group.group];
    species[group.group] =
      group.group === 'levels' ? readLevels(group, content, faults) : readGroup(group, content, group.group, 0, faults);
  }
  return faults.length > 0 ? { faults } : { species: species as unknown as Species };
}

function readLevels(group: Group, value: unknown, faults: Fault[]): Fields[] {
  if (!Array.isArray(value) || value.length < 1 || value.length > MOST_LEVELS) {
    faults.push({
      path: 'levels',
      found: foundText(value),
      allowed: `a list of 1 to ${MOST_LEVELS} levels, the trunk first`,
    });
    return [];
  }
  return value.map((entry, level) => readGroup(group, entry, `levels[${level}]`, level, faults));
}

/** The parameters of a group at their place in the file, with defaults filled in; faults go on the list. */
function readGroup(group: Group, value: unknown, path: string, level: number, faults: Fault[]): Fields {
  const optional = !group.parameters.some((p) => isRequired(p, level));
  const fields = value === undefined && optional ? {} : fieldsOf(value, path, faults);
  if (!fields) return {};
  const keys = group.parameters.map((p) => p.key);
  unknownKeys(fields, `${path}.`, keys, faults);
  const read: Record<string, unknown> = {};
  for (const p of group.parameters) {
    const found = Object.hasOwn(fields, p.key) ? fields[p.key] : undefined;
    const kept =
      found === undefined && !isRequired(p, level)
        ? defaultOf(p, level)
        : checked(p, found, `${path}.${p.key}`, faults);
    if (kept !== undefined) read[p.key] = kept;
  }
  return read;
}

function checked(p: Parameter, value: unknown, path: string, faults: Fault[]): unknown {
  if (isAllowed(p, value)) return value;
  faults.push({ path, found: foundText(value), allowed: allowedValues(p) });
  return undefined;
}

function fieldsOf(value: unknown, path: string, faults: Fault[]): Fields | undefined {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Fields;
  faults.push({ path, found: foundText(value), allowed: 'an object' });
  return undefined;
}

function unknownKeys(fields: Fields, prefix: string, known: readonly string[], faults: Fault[]): void {
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
