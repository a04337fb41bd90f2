import { expect, test } from 'vitest';
import { grow } from '../../../src/core/grow/grow.ts';
import { treeStats } from '../../../src/core/grow/stats.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { edit, plain, shipped, withoutVariation } from './species.ts';

test('figures of a tree that can be counted by hand', () => {
  const species = edit(plain, {
    tree: { levels: 2, ratio: 0.02 },
    levels: { 0: { curveRes: 5, baseSplits: 1 }, 1: { curveRes: 4, downAngle: 90, branches: 20, taper: 0 } },
  });
  const stats = treeStats(grow(species, 9));
  expect(stats).toMatchObject({
    species: 'Quaking Aspen',
    seed: 9,
    leaves: 0,
    pieces: 0,
    maxDepth: 0,
    bytes: 0,
    milliseconds: 0,
  });
  expect(stats.height).toBeCloseTo(10, 5);
  expect(stats.radius).toBeCloseTo(3, 5);
  const [trunk, branches] = stats.levels;
  // One stem of 5 segments and one clone of the 4 above the first: the clone counts in nothing else.
  expect(trunk).toMatchObject({ level: 0, stems: 1, clones: 1, segments: 9, declinationDeg: { mean: 0 } });
  expect(trunk.length).toEqual({ sum: 10, mean: 10, min: 10, max: 10 });
  expect(trunk.baseRadius.mean).toBeCloseTo(0.2, 6);
  expect(branches).toMatchObject({ level: 1, clones: 0, segments: 4 * branches.stems });
  expect(branches.length.sum).toBeCloseTo(3 * branches.stems, 3);
  expect(branches.declinationDeg.mean).toBeCloseTo(90, 3);
});

test('segments are those of the paper in a helix too', () => {
  const helix = edit(plain, { levels: { 0: { curveV: -30, curveRes: 6 } } });
  expect(treeStats(grow(helix, 1)).levels[0].segments).toBe(6);
});

test('pieces, depth and bytes come from what is packed', () => {
  const { stats, packed, pieces } = growPacked(withoutVariation(shipped('quaking-aspen')), 1);
  expect(stats.pieces).toBe(pieces.count);
  expect(stats.levels.reduce((sum, level) => sum + level.pieces, 0)).toBe(pieces.count);
  expect(stats.maxDepth).toBe(pieces.maxDepth);
  expect(stats.bytes).toBe(
    [packed.pieces, packed.restPose, packed.restPose, packed.branches, packed.leaves].reduce(
      (sum, { data }) => sum + 4 * data.length,
      0,
    ),
  );
});
