import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { grow } from '../../../src/core/grow/grow.ts';
import { blend, blendName } from '../../../src/core/species/blend.ts';
import { editSpecies, mayBe, PLACES, valueAt } from '../../../src/core/species/edits.ts';
import { mixColours, oklabOf } from '../../../src/core/species/oklab.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import type { Species } from '../../../src/core/species/species.ts';
import { moreLikeThis, randomise, VARIANTS } from '../../../src/core/species/variety.ts';
import { names, shipped } from '../grow/species.ts';

const all = names.map(shipped);
const [aspen, tupelo, willow, oak] = all as [Species, Species, Species, Species];
const paths = [...PLACES.keys()];
const anySpecies = fc.constantFrom(...all);
const anySeed = fc.integer({ min: 0, max: 2 ** 32 - 1 });
/** From file to species and back, nothing is at fault and nothing is added. */
const isFile = (species: Species): void =>
  expect(parseSpecies(JSON.stringify(species))).toEqual({ species: JSON.parse(JSON.stringify(species)) });

describe('randomise', () => {
  test('gives allowed values that are a species, leaves locks alone, and does the same again', () => {
    fc.assert(
      fc.property(
        anySpecies,
        anySeed,
        fc.double({ min: 0, max: 1, noNaN: true }),
        fc.subarray(paths),
        (species, seed, amount, locked) => {
          const locks = new Set(locked);
          const edits = randomise(species, seed, amount, locks);
          for (const [path, value] of Object.entries(edits)) {
            expect(mayBe(path, value), path).toBe(true);
            expect(locks.has(path), path).toBe(false);
            expect(value).not.toEqual(valueAt(species, path));
          }
          isFile(editSpecies(species, edits));
          expect(randomise(species, seed, amount, locks)).toEqual(edits);
        },
      ),
      { numRuns: 300 },
    );
  });

  test('none where the amount is 0 or everything is locked', () => {
    expect(randomise(oak, 1, 0)).toEqual({});
    expect(randomise(oak, 1, 1, new Set(paths))).toEqual({});
  });

  test("moves a parameter within its species' own variation", () => {
    const sizes = Array.from({ length: 200 }, (_, seed) => randomise(aspen, seed, 1)['tree.scale'] ?? 13) as number[];
    expect(Math.min(...sizes)).toBeGreaterThanOrEqual(10);
    expect(Math.max(...sizes)).toBeLessThanOrEqual(16);
    expect(Math.max(...sizes) - Math.min(...sizes)).toBeGreaterThan(4);
    const half = Array.from({ length: 200 }, (_, seed) => randomise(aspen, seed, 0.5)['tree.scale'] ?? 13) as number[];
    expect(Math.min(...half)).toBeGreaterThanOrEqual(11.5);
    expect(Math.max(...half)).toBeLessThanOrEqual(14.5);
  });

  test('keeps what the species is, and gives it nothing that it has not', () => {
    fc.assert(
      fc.property(anySpecies, anySeed, (species, seed) => {
        const other = editSpecies(species, randomise(species, seed, 1));
        expect(other.tree.shape).toBe(species.tree.shape);
        expect(other.tree.levels).toBe(species.tree.levels);
        expect(other.switches).toEqual(species.switches);
        expect(other.levels.length).toBe(species.levels.length);
        species.levels.forEach((level, n) => {
          expect(Math.sign(other.levels[n]!.branches)).toBe(Math.sign(level.branches));
          expect(Math.sign(other.levels[n]!.segSplits)).toBe(Math.sign(level.segSplits));
          expect(Math.sign(other.levels[n]!.rotate)).toBe(Math.sign(level.rotate));
        });
      }),
    );
  });
});

test('twelve more like this: all different, each spread over the width, the same again', () => {
  const variants = moreLikeThis(aspen, 7, 1);
  expect(variants).toHaveLength(VARIANTS);
  expect(new Set(variants.map((v) => JSON.stringify(v))).size).toBe(VARIANTS);
  expect(moreLikeThis(aspen, 7, 1)).toEqual(variants);
  // One in each twelfth of 10..16 m.
  const twelfths = variants.map((v) => Math.floor(((((v['tree.scale'] as number) ?? 13) - 10) / 6) * VARIANTS));
  expect([...twelfths].sort((a, b) => a - b)).toEqual(Array.from({ length: VARIANTS }, (_, i) => i));
});

describe('blend', () => {
  test('is one parent at each end and a species of its own between', () => {
    fc.assert(
      fc.property(anySpecies, anySpecies, fc.double({ min: 0, max: 1, noNaN: true }), (a, b, t) => {
        const child = blend(a, b, t);
        isFile(child);
        if (t > 0 && t < 1) expect(child.name).toBe(blendName(a.name, b.name, t));
        for (const { path, parameter } of PLACES.values()) {
          const [from, to, value] = [valueAt(a, path), valueAt(b, path), valueAt(child, path)];
          if (parameter.kind !== 'number' || parameter.names || path.endsWith('rotate') || path === 'leaves.count')
            continue;
          if (typeof from !== 'number' || typeof to !== 'number' || typeof value !== 'number') continue;
          // Counts of a level that only one of them grows run towards 1.
          expect(value, path).toBeGreaterThanOrEqual(Math.min(from, to, 1) - 1e-9);
          expect(value, path).toBeLessThanOrEqual(Math.max(from, to) + 1e-9);
        }
      }),
      { numRuns: 200 },
    );
    expect(blend(aspen, oak, 0)).toBe(aspen);
    expect(blend(aspen, oak, 1)).toBe(oak);
  });

  test('mixes numbers and counts, switches shapes and choices at the half, turns the short way', () => {
    const a = editSpecies(aspen, { 'levels.1.rotate': 350, 'tree.scale': 10, 'levels.1.branches': 10 });
    const b = editSpecies(oak, { 'levels.1.rotate': 30, 'tree.scale': 20, 'levels.1.branches': 90 });
    expect(blend(a, b, 0.5).levels[1]!.rotate).toBe(10);
    expect(blend(a, b, 0.25).levels[1]!.rotate).toBe(0);
    expect(blend(a, b, 0.3).tree.scale).toBe(13);
    expect(blend(a, b, 0.5).levels[1]!.branches).toBe(30);
    expect(blend(a, b, 0.49).tree.shape).toBe(aspen.tree.shape);
    expect(blend(a, b, 0.5).tree.shape).toBe(oak.tree.shape);
    expect(blend(a, b, 0.49).bark.kind).toBe(aspen.bark.kind);
    expect(blend(a, b, 0.5).bark.kind).toBe(oak.bark.kind);
  });

  test('mixes colours as eyes do: the lightness of the middle is the middle of the lightnesses', () => {
    const L = (colour: string): number => oklabOf(colour)[0];
    expect(L(mixColours('#0000ff', '#ffff00', 0.5))).toBeCloseTo((L('#0000ff') + L('#ffff00')) / 2, 2);
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 0xffffff }), (n) => {
        const colour = `#${n.toString(16).padStart(6, '0')}`;
        expect(mixColours(colour, '#123456', 0)).toBe(colour);
      }),
    );
  });

  test('leaves stand as those of both parents between them, though only one says how', () => {
    const a = editSpecies(aspen, { 'leaves.downAngle': 80 });
    const ownAngle = aspen.levels[3]!.downAngle;
    expect(blend(a, aspen, 0.25).leaves.downAngle).toBeCloseTo(80 + 0.25 * (ownAngle - 80), 1);
    expect(blend(aspen, oak, 0.4).leaves.downAngle).toBeUndefined();
  });

  test('a crown drawn as a curve meets the shape of the other', () => {
    const a = editSpecies(aspen, { 'tree.crown': [1, 1] });
    expect(blend(a, editSpecies(oak, { 'tree.crown': [0, 1] }), 0.5).tree.crown).toEqual([0.5, 1]);
    const crown = blend(a, editSpecies(oak, { 'tree.shape': 9 }), 0.5).tree.crown!;
    expect([crown[0], crown.at(-1)]).toEqual([1, 0.5]);
    expect(blend(aspen, oak, 0.5).tree.crown).toBeUndefined();
  });

  test('a name fits into a file, however long those of the parents are', () => {
    expect(blendName('Aspen', 'Oak', 0.3)).toBe('Aspen × Oak 30 %');
    const long = 'x'.repeat(80);
    expect(blendName(long, long, 0.5).length).toBeLessThanOrEqual(80);
  });
});

describe('what comes out grows within the budget', () => {
  test('blends of the shipped species have no more leaves than the fuller of their parents, by far', () => {
    // Leaves are what counts: a count of them is enough, and the willow alone has the most.
    const leaves = (species: Species): number => grow(species, 1).leaves.count;
    const [few, many] = [leaves(aspen), leaves(willow)];
    for (const t of [0.2, 0.49, 0.5, 0.8]) {
      const count = leaves(blend(aspen, willow, t));
      expect(count, `t = ${t}`).toBeGreaterThan(few / 3);
      expect(count, `t = ${t}`).toBeLessThan(many * 1.3);
    }
  });

  test('variants grow, and not much more than their species', () => {
    const count = (species: Species): number => grow(species, 1, { leaves: false }).stems.count;
    for (const species of [aspen, tupelo, oak]) {
      const own = count(species);
      for (const edits of moreLikeThis(species, 3, 1).slice(0, 4)) {
        expect(count(editSpecies(species, edits))).toBeLessThan(own * 1.6);
      }
    }
  });
});
