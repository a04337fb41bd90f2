import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { faultText } from '../../../src/core/file/fault.ts';
import { GrowthBudgetError } from '../../../src/core/grow/budget.ts';
import { NothingGrownError } from '../../../src/core/grow/nothing-grown.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { editSpecies, mayBe, PLACES, valueAt } from '../../../src/core/species/edits.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import type { Species } from '../../../src/core/species/species.ts';
import { mutatedTexts, unsound } from '../file/mutations.ts';
import { folder, names } from '../grow/species.ts';
import { anyEdits } from './any-edits.ts';

const texts = names.map((name) => readFileSync(join(folder, `${name}.json`), 'utf8'));

/** Of the paths of a species, those whose value may not be there. */
const wrongAt = (species: Species): string[] =>
  [...PLACES.keys()].filter((path) => {
    const { parameter, level = 0 } = PLACES.get(path)!;
    const value = valueAt(species, path);
    // What a level need not have may be absent from it.
    return level < species.levels.length && !mayBe(path, value) && !(value === null && parameter.levels !== undefined);
  });

describe('4000 mutated species files', () => {
  it('are read as a species that is sound, or give faults of one line each; nothing else', () => {
    let good = 0;
    fc.assert(
      fc.property(mutatedTexts(texts), (text) => {
        const { species, faults } = parseSpecies(text);
        if (species) {
          good++;
          expect(unsound(species)).toEqual([]);
          expect(wrongAt(species)).toEqual([]);
          expect(parseSpecies(JSON.stringify(species)).species).toEqual(species);
          return;
        }
        expect(faults!.length).toBeGreaterThan(0);
        for (const fault of faults!) {
          expect(faultText(fault)).toMatch(/^[^\p{Cc}\u2028\u2029\u202e]{1,2000}$/u);
        }
      }),
      { numRuns: 4000 },
    );
    // Where nothing passes, nothing is tried.
    expect(good).toBeGreaterThan(100);
  });
});

describe('200 species of any values', () => {
  it('grow within a small budget to a tree that is sound, or say why not', () => {
    const budget = { stems: 200, leaves: 200, bytes: 1_000_000 };
    let grown = 0;
    fc.assert(
      fc.property(fc.constantFrom(...texts), anyEdits, fc.nat(), (text, edits, seed) => {
        const species = editSpecies(parseSpecies(text).species!, edits);
        try {
          const { packed } = growPacked(species, seed, { budget, levels: 2 });
          grown++;
          for (const array of [packed.pieces.data, packed.restPose.data, packed.mechanics, packed.bounds, packed.crown])
            expect(array.every(Number.isFinite)).toBe(true);
        } catch (error) {
          if (!(error instanceof GrowthBudgetError || error instanceof NothingGrownError)) throw error;
        }
      }),
      { numRuns: 200 },
    );
    expect(grown).toBeGreaterThan(20);
  });
});
