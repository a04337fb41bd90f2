import { foundText } from './allowed.ts';
import type { Fault } from './fault.ts';
import { fieldsOf, unknownKeys } from './read.ts';

/** A file that ships, as the list beside it has it. Winds have a description and a thumbnail, species a Latin name. */
export interface IndexEntry {
  /** What links call it. */
  readonly id: string;
  readonly name: string;
  /** The file beside the list. */
  readonly file: string;
  readonly latin?: string;
  readonly description?: string;
  readonly thumbnail?: string;
}

const ID = /^[a-z0-9]+(-[a-z0-9]+)*$/;
const FILE = /^[\w-][\w.-]*$/;

/** What the texts of an entry may be; an entry need not have the last three. */
const KEYS: Readonly<Record<keyof IndexEntry, readonly [RegExp, string]>> = {
  id: [ID, 'small letters and digits with hyphens between, as "light-air"'],
  name: [/\S/, 'a text'],
  file: [FILE, 'the name of a file beside this one'],
  latin: [/\S/, 'a text'],
  description: [/\S/, 'a text'],
  thumbnail: [FILE, 'the name of a file beside this one'],
};
const REQUIRED: readonly string[] = ['id', 'name', 'file'];

export type ParsedIndex =
  | { readonly entries: readonly IndexEntry[]; readonly faults?: undefined }
  | { readonly entries?: undefined; readonly faults: readonly Fault[] };

/** The list of the files that ship from what JSON.parse made of it; every fault where there are any. Never throws. */
export function parseIndex(value: unknown): ParsedIndex {
  const faults: Fault[] = [];
  if (!Array.isArray(value)) return { faults: [{ path: '', found: foundText(value), allowed: 'a list of files' }] };
  const ids = new Set<unknown>();
  value.forEach((entry, i) => {
    const fields = fieldsOf(entry, `[${i}]`, faults);
    if (!fields) return;
    unknownKeys(fields, `[${i}].`, Object.keys(KEYS), faults);
    for (const [key, [pattern, allowed]] of Object.entries(KEYS)) {
      const text = fields[key];
      if (text === undefined && !REQUIRED.includes(key)) continue;
      if (typeof text !== 'string' || !pattern.test(text))
        faults.push({ path: `[${i}].${key}`, found: foundText(text), allowed });
    }
    if (ids.has(fields.id))
      faults.push({ path: `[${i}].id`, found: foundText(fields.id), allowed: 'an id that no other has' });
    ids.add(fields.id);
  });
  return faults.length > 0 ? { faults } : { entries: value };
}
