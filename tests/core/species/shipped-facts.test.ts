// The list of the species that ship says what their files say, and has the pictures that it names.
import { existsSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import {
  folder,
  IN_SEASON,
  indexText,
  PORTRAIT,
  portraitOf,
  readEntry,
  readIndex,
  seasonOf,
  THUMBNAIL,
  thumbnailOf,
  wholeEntry,
} from '../../../docs/species-index.ts';
import { parseIndex } from '../../../src/core/file/shipped-index.ts';
import { shippedFacts } from '../../../src/core/species/shipped-facts.ts';

const entries = readIndex();
const bytes = (path: string): number => (existsSync(join(folder, path)) ? statSync(join(folder, path)).size : 0);

test('the list is a good one, as docs/make-species-index.ts writes it', () => {
  expect(parseIndex(entries).faults).toBeUndefined();
  expect(entries).toEqual(JSON.parse(indexText(entries.map(wholeEntry))));
});

describe.each(entries)('$id', (entry) => {
  const { species } = readEntry(entry);

  test('is called in the list as in its file', () => {
    expect([entry.name, entry.latin]).toEqual([species.name, species.latin]);
  });

  // Another run of docs/make-portraits.ts makes what is missing.
  test('has a portrait, a thumbnail and a picture of each season that differs, small enough', () => {
    const wanted = [
      [portraitOf(entry.id), PORTRAIT.bytes],
      [thumbnailOf(entry.id), THUMBNAIL.bytes],
      ...shippedFacts(species).seasons.map((season) => [seasonOf(entry.id, season), IN_SEASON.bytes] as const),
    ] as const;
    for (const [path, most] of wanted) {
      expect(bytes(path), path).toBeGreaterThan(500);
      expect(bytes(path), path).toBeLessThanOrEqual(most);
    }
  });
});

test('no picture is left of a species or season that is not there', () => {
  const known = entries.flatMap((entry) => [
    portraitOf(entry.id),
    thumbnailOf(entry.id),
    ...shippedFacts(readEntry(entry).species).seasons.map((season) => seasonOf(entry.id, season)),
  ]);
  expect(readdirSync(join(folder, 'portraits')).filter((file) => !known.includes(`portraits/${file}`))).toEqual([]);
});
