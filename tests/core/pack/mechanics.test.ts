import { describe, expect, test } from 'vitest';
import { grow } from '../../../src/core/grow/grow.ts';
import { MECHANICS, MECHANICS_SIZE } from '../../../src/core/pack/layout.ts';
import { OMEGA_RANGE, packMechanics, stemFrequencies } from '../../../src/core/pack/mechanics.ts';
import { fitPieces } from '../../../src/core/pieces/fit-pieces.ts';
import type { Species } from '../../../src/core/species/species.ts';
import { SHIPPED, shippedSpecies } from './shipped-species.ts';

const median = (values: number[]): number => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
const hertz = (omega: number): number => omega / (2 * Math.PI);

/** Frequencies of each level of a tree in hertz: slowest, median, fastest. */
function levelsOf(species: Species) {
  const tree = grow(species, 1);
  const omega = stemFrequencies(tree);
  const levels: number[][] = [];
  omega.forEach((w, i) => {
    levels[tree.stems.level[i]] ??= [];
    levels[tree.stems.level[i]].push(hertz(w));
  });
  return levels.map((all) => ({ least: Math.min(...all), middle: median(all), most: Math.max(...all), all }));
}

describe.each(SHIPPED)('%s', (name) => {
  const species = shippedSpecies(name);
  const levels = levelsOf(
    name === 'weeping-willow' ? { ...species, leaves: { ...species.leaves, count: 1 } } : species,
  );

  test('swings as trees do: the trunk slower than a hertz or so, limbs up to 2, nothing beyond the limits', () => {
    const [trunk, limbs] = levels;
    expect(trunk.middle).toBeGreaterThan(0.25);
    expect(trunk.middle).toBeLessThan(1.2);
    expect(limbs.middle).toBeGreaterThan(0.5);
    expect(limbs.middle).toBeLessThan(2);
    for (const { least, most } of levels) {
      expect(least).toBeGreaterThanOrEqual(hertz(OMEGA_RANGE[0]));
      expect(most).toBeLessThanOrEqual(hertz(OMEGA_RANGE[1]) + 1e-9);
    }
  });

  test('no two twigs in unison: frequencies spread by a tenth or more, also where the limit holds them', () => {
    const { all, middle } = levels[levels.length - 1];
    const spread = Math.sqrt(all.reduce((sum, f) => sum + (f / middle - 1) ** 2, 0) / all.length);
    expect(spread).toBeGreaterThan(0.08);
    expect(new Set(all).size).toBeGreaterThan(0.99 * all.length);
  });
});

describe('mechanics', () => {
  const aspen = shippedSpecies('quaking-aspen');
  const small = { ...aspen, tree: { ...aspen.tree, levels: 2 }, leaves: { ...aspen.leaves, count: 0 } };
  const change = (wind: Partial<Species['wind']>): Species => ({ ...small, wind: { ...small.wind, ...wind } });
  const trunk = (species: Species): number => stemFrequencies(grow(species, 1))[0];

  test('follow the cantilever: the root of stiffness over density; weight is an addition that both share', () => {
    const swing = (1.5 * 9.81) / grow(small, 1).stems.length[0];
    const varied = (omega: number, scale: number) => (omega / scale) ** 2;
    // The factor by which this stem differs from others of its size.
    const scale = Math.sqrt(
      (varied(trunk(change({ modulus: 8 })), 1) - varied(trunk(change({ modulus: 4 })), 1)) /
        (varied(trunk(change({ modulus: 6 })), 1) - varied(trunk(change({ modulus: 4 })), 1)),
    );
    expect(scale).toBeCloseTo(Math.SQRT2, 6);
    expect(trunk(change({ modulus: 0.1 }))).toBeGreaterThan(0.8 * Math.sqrt(swing));
    expect(trunk(change({ density: 1400 }))).toBeLessThan(trunk(change({ density: 350 })));
  });

  test('leaves slow what bears them', () => {
    const leafy = { ...aspen, leaves: { ...aspen.leaves, count: 25 } };
    const heavy = { ...leafy, wind: { ...leafy.wind, leafMass: 1 } };
    const [light, slow] = [leafy, heavy].map((species) => stemFrequencies(grow(species, 1)));
    expect(slow[0]).toBeLessThan(0.95 * light[0]);
    expect(slow.every((w, i) => w <= light[i] + 1e-9)).toBe(true);
  });

  test('are those of the stem on each of its pieces', () => {
    const levels = small.levels.map((level) => ({ ...level, curveV: 150 }));
    const tree = grow({ ...small, levels, wind: { ...small.wind, damping: 1.5 } }, 3);
    const pieces = fitPieces(tree);
    const mechanics = packMechanics(tree, pieces);
    const omega = stemFrequencies(tree);
    const at = (i: number, key: keyof typeof MECHANICS): number => mechanics[MECHANICS_SIZE * i + MECHANICS[key]];
    let chained = 0;
    for (let i = 0; i < pieces.count; i++) {
      const stem = pieces.stem[i];
      expect(at(i, 'OMEGA')).toBeCloseTo(omega[stem], 5);
      expect(at(i, 'LENGTH')).toBe(tree.stems.length[stem]);
      expect(at(i, 'FLEXIBILITY')).toBeCloseTo(1 / small.wind.stiffness[pieces.level[i]], 6);
      expect(at(i, 'DAMPING')).toBe(1.5);
      const next = pieces.next[i];
      if (next < 0) continue;
      chained++;
      expect(at(next, 'PHASE')).toBe(at(i, 'PHASE'));
      expect(at(next, 'Z0')).toBe(at(i, 'Z1'));
    }
    expect(chained).toBeGreaterThan(3);
    const phases = [...pieces.firstOfStem].map((p) => at(p, 'PHASE'));
    expect(new Set(phases).size).toBe(phases.length);
  });
});
