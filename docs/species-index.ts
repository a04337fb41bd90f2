// The list of the species that ship: what authors write by hand (id, name, latin, file, seed), and what their files say.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { faultText } from '../src/core/file/fault.ts';
import type { IndexEntry } from '../src/core/file/shipped-index.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import type { Season } from '../src/core/species/season.ts';
import { shippedFacts } from '../src/core/species/shipped-facts.ts';
import type { Species } from '../src/core/species/species.ts';

/** Folder of the species. */
export const folder = join(import.meta.dirname, '../public/species');

/** Pixels of the pictures, and bytes that each may have. */
export const PORTRAIT = { width: 480, height: 600, bytes: 45_000 } as const;
export const THUMBNAIL = { width: 160, height: 200, bytes: 10_000 } as const;
export const IN_SEASON = { width: 240, height: 300, bytes: 18_000 } as const;

/** Where the pictures of a species lie, beside the list. */
export const portraitOf = (id: string): string => `portraits/${id}.webp`;
export const thumbnailOf = (id: string): string => `portraits/${id}-small.webp`;
export const seasonOf = (id: string, season: Season): string => `portraits/${id}-${season}.webp`;

export const readIndex = (): readonly IndexEntry[] => JSON.parse(readFileSync(join(folder, 'index.json'), 'utf8'));

/** A species of the list; throws where its file is wrong. */
export function readEntry({ file }: IndexEntry): { readonly text: string; readonly species: Species } {
  const text = readFileSync(join(folder, file), 'utf8');
  const { species, faults } = parseSpecies(text);
  if (!species) throw new Error(`${file}:\n${faults.map(faultText).join('\n')}`);
  return { text, species };
}

/** An entry as it should be: what is written by hand, what the file says, and the pictures that are there. */
export function wholeEntry(entry: IndexEntry): IndexEntry {
  const { id, name, latin, file, seed } = entry;
  const { kind, height, seasons } = shippedFacts(readEntry(entry).species);
  const portrait = portraitOf(id);
  const thumbnail = thumbnailOf(id);
  return {
    id,
    name,
    ...(latin === undefined ? {} : { latin }),
    file,
    ...(seed === undefined ? {} : { seed }),
    ...(kind === undefined ? {} : { kind }),
    ...(height === undefined ? {} : { height }),
    seasons,
    ...(existsSync(join(folder, portrait)) ? { portrait } : {}),
    ...(existsSync(join(folder, thumbnail)) ? { thumbnail } : {}),
  };
}

/** The list as its file has it. */
export const indexText = (entries: readonly IndexEntry[]): string =>
  `${JSON.stringify(entries, null, 2).replace(/\[\n\s+([^[\]{}]*?)\n\s+\]/g, (_, inner: string) => `[${inner.replace(/\n\s+/g, ' ')}]`)}\n`;
