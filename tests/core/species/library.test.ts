// Every species that ships: valid, told about, within the budget of a live picture, and of the proportions that its facts give.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { grow } from '../../../src/core/grow/grow.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import { type Proportions, proportions } from '../../../src/core/species/proportions.ts';
import type { Species } from '../../../src/core/species/species.ts';
import { edit, folder, mean, names, plain } from '../grow/species.ts';

interface Entry {
  readonly id: string;
  readonly file: string;
}

const entries: readonly Entry[] = JSON.parse(readFileSync(join(folder, 'index.json'), 'utf8'));
const parse = (file: string) => parseSpecies(readFileSync(join(folder, file), 'utf8'));

const SEEDS = 20;
/** How far a single tree may lie outside the range of its kind, as a part of the range's end; the mean may not. */
const STRAY = 0.25;
/** A clear stem near the ground has no range to speak of, so it may stray by this part of the height. */
const STRAY_CLEAR = 0.05;
/** What a live picture of one tree can afford. The paper's four have the paper's numbers, whatever they cost. */
const MOST = { leaves: 60_000, pieces: 12_000 };

function measured(species: Species): Proportions[] {
  const levels = Math.min(species.tree.levels, 3);
  return Array.from({ length: SEEDS }, (_, seed) => proportions(grow(species, seed, { levels, leaves: false })));
}

describe.each(entries)('$id', ({ id, file }) => {
  const { species, faults } = parse(file);

  test('is a valid file that says what it is', () => {
    expect(faults).toBeUndefined();
    expect(species?.facts).toBeDefined();
    expect(species?.description.length).toBeGreaterThan(120);
  });

  test('writes down its bark, its leaves and how it answers the wind, and leaves nothing of them to defaults', () => {
    const told = JSON.parse(readFileSync(join(folder, file), 'utf8'));
    expect(told.wind).toMatchObject({ modulus: expect.any(Number), density: expect.any(Number) });
    expect(told.wind.stiffness.length).toBeGreaterThanOrEqual(Math.min(4, species!.tree.levels));
    expect(told.bark).toMatchObject({ kind: species!.bark.kind, colour: species!.bark.colour });
    expect(told.foliage).toMatchObject(species!.foliage.cover > 0 ? { colour: species!.foliage.colour } : { cover: 0 });
    expect(told.levels.length).toBeGreaterThanOrEqual(Math.min(4, species!.tree.levels));
    // The paper's four swing as they did before species had a damping of their own.
    expect(told.wind.damping === undefined).toBe(names.some((name) => name === id));
  });

  test('grows within the budget of a live picture', () => {
    if (names.some((name) => name === id)) return;
    const { stats } = growPacked(species!, 1);
    expect(stats.leaves).toBeLessThanOrEqual(MOST.leaves);
    expect(stats.pieces).toBeLessThanOrEqual(MOST.pieces);
  });

  test('has the height, spread and clear stem of its kind', () => {
    const facts = species!.facts!;
    const trees = measured(species!);
    for (const key of ['height', 'spread', 'clear'] as const) {
      const [least, most] = facts[key];
      const values = trees.map((tree) => tree[key]);
      const room = key === 'clear' ? STRAY_CLEAR : 0;
      expect(mean(values), `mean ${key}`).toBeGreaterThanOrEqual(least);
      expect(mean(values), `mean ${key}`).toBeLessThanOrEqual(most);
      // The printed Scale and ScaleV of the oak, 10 +- 10, make saplings too.
      if (id === 'california-black-oak' && key === 'height') continue;
      values.forEach((value, seed) => {
        expect(value, `${key}, seed ${seed}`).toBeGreaterThanOrEqual(least * (1 - STRAY) - room);
        expect(value, `${key}, seed ${seed}`).toBeLessThanOrEqual(most * (1 + STRAY) + room);
      });
    }
  });
});

test('proportions are those of a tree whose branches one can reckon', () => {
  // Branches of 3 m stand level from a tenth of a trunk of 10 m on; a share of them points along each axis, nearly.
  const tree = edit(plain, { tree: { levels: 2, baseSize: 0.1 }, levels: { 1: { branches: 200 } } });
  const { height, spread, clear } = proportions(grow(tree, 1));
  expect(height).toBeCloseTo(10, 5);
  expect(spread).toBeCloseTo(0.6, 2);
  expect(clear).toBeGreaterThanOrEqual(0.1);
  expect(clear).toBeLessThan(0.11);
});

test('stubs do not end the clear stem, and a bare trunk has none', () => {
  // A cone's length falls to nothing at the top; here it is upside down, so that the lowest branches are stubs.
  const tree = edit(plain, { tree: { levels: 2, crown: [0, 1] }, levels: { 1: { branches: 400 } } });
  expect(proportions(grow(tree, 1)).clear).toBeCloseTo(1 / 3, 1);
  expect(proportions(grow(edit(plain, { tree: { levels: 1 } }), 1))).toMatchObject({ spread: 0, clear: 0 });
});
