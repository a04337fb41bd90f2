import { SEASONS } from '../species/season.ts';
import type { ShippedFacts } from '../species/shipped-facts.ts';
import { SPECIES_KINDS } from '../species/species.ts';
import { foundText } from './allowed.ts';
import type { Fault } from './fault.ts';
import { fieldsOf, unknownKeys } from './read.ts';

/** A file that ships, as the list beside it has it. Winds have a description and a thumbnail, species a Latin name and what a gallery shows. */
export interface IndexEntry extends Partial<ShippedFacts> {
  /** What links call it. */
  readonly id: string;
  readonly name: string;
  /** The file beside the list. */
  readonly file: string;
  readonly latin?: string;
  readonly description?: string;
  readonly thumbnail?: string;
  /** Picture of the species, and the seed of the tree in all its pictures; that of a season is called `portraits/ID-SEASON.webp`. */
  readonly portrait?: string;
  readonly seed?: number;
}

/** The seed of the pictures of a species: 1 where the list names none. */
export const seedOf = ({ seed = 1 }: IndexEntry): number => seed;

const ID = /^[a-z0-9]+(-[a-z0-9]+)*$/;
const FILE = /^[\w-][\w.-]*$/;
const PICTURE = /^([\w-]+\/)?[\w-][\w.-]*$/;

type Rule = readonly [(value: unknown) => boolean, string];

const text = (pattern: RegExp, allowed: string): Rule => [(v) => typeof v === 'string' && pattern.test(v), allowed];
const isPart = (list: readonly string[], value: unknown): boolean => list.some((each) => each === value);
const isHeight = (v: unknown): boolean =>
  Array.isArray(v) && v.length === 2 && v.every((x) => typeof x === 'number' && x > 0) && v[0] <= v[1];

/** What the values of an entry may be; an entry need not have those that are not `REQUIRED`. */
const KEYS: Readonly<Record<keyof IndexEntry, Rule>> = {
  id: text(ID, 'small letters and digits with hyphens between, as "light-air"'),
  name: text(/\S/, 'a text'),
  file: text(FILE, 'the name of a file beside this one'),
  latin: text(/\S/, 'a text'),
  description: text(/\S/, 'a text'),
  thumbnail: text(PICTURE, 'the name of a file beside this one'),
  portrait: text(PICTURE, 'the name of a file beside this one'),
  seed: [(v) => Number.isInteger(v) && (v as number) >= 0, 'a whole number from 0'],
  kind: [(v) => isPart(SPECIES_KINDS, v), SPECIES_KINDS.join(', ')],
  height: [isHeight, 'two numbers above 0, metres, the smaller first'],
  seasons: [(v) => Array.isArray(v) && v.every((each) => isPart(SEASONS, each)), `a list of ${SEASONS.join(', ')}`],
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
    for (const [key, [mayBe, allowed]] of Object.entries(KEYS)) {
      const found = fields[key];
      if (found === undefined && !REQUIRED.includes(key)) continue;
      if (!mayBe(found)) faults.push({ path: `[${i}].${key}`, found: foundText(found), allowed });
    }
    if (ids.has(fields.id))
      faults.push({ path: `[${i}].id`, found: foundText(fields.id), allowed: 'an id that no other has' });
    ids.add(fields.id);
  });
  return faults.length > 0 ? { faults } : { entries: value };
}
