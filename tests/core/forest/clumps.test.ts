import { describe, expect, test } from 'vitest';
import { clumpTree } from '../../../src/core/forest/clump-tree.ts';
import { clumpsOf } from '../../../src/core/forest/clumps.ts';
import { leafPoints } from '../../../src/core/look/leaf-points.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { MECHANICS, MECHANICS_SIZE } from '../../../src/core/pack/layout.ts';
import { shippedSpecies } from '../pack/shipped-species.ts';

const species = shippedSpecies('quaking-aspen');
const { packed } = growPacked(species, 5);
const clumps = clumpsOf(packed);

describe('clumps of a tree', () => {
  test('hold every leaf and every twig, and no stem of level 0 or 1', () => {
    expect(clumps.count).toBeGreaterThanOrEqual(60);
    expect(clumps.count).toBeLessThanOrEqual(200);
    expect(clumps.size.reduce((a, b) => a + b)).toBe(packed.leafCount);
    for (let i = 0; i < packed.pieceCount; i++) {
      const twig = packed.mechanics[MECHANICS_SIZE * i + MECHANICS.LEVEL]! >= 2;
      expect(clumps.ofPiece[i]! >= 0).toBe(twig);
    }
  });

  test('are much smaller than the crown, and hold most of their leaves within their radius', () => {
    const feet = leafPoints(packed, packed.leafCount);
    let inside = 0;
    clumps.ofLeaf.forEach((c, i) => {
      const away = Math.hypot(...[0, 1, 2].map((k) => feet[3 * i + k]! - clumps.centre[3 * c + k]!));
      if (away <= clumps.radius[c]!) inside++;
    });
    expect(inside / packed.leafCount).toBeGreaterThan(0.9);
    const mean = clumps.radius.reduce((a, b) => a + b) / clumps.count;
    expect(mean).toBeLessThan(0.35 * packed.crown[3]!);
  });

  test('are the same for the same tree, and each has the stem that most of it grows on', () => {
    expect(clumpsOf(growPacked(species, 5).packed)).toEqual(clumps);
    for (let c = 0; c < clumps.count; c++) {
      expect(packed.mechanics[MECHANICS_SIZE * clumps.carrier[c]! + MECHANICS.LEVEL]).toBeLessThan(2);
      expect(clumps.v[c]).toBeGreaterThanOrEqual(0);
      expect(clumps.v[c]).toBeLessThanOrEqual(1);
    }
  });

  test('one by itself is a tree with its own leaves and twigs alone', () => {
    const alone = clumpTree(packed, clumps, 7);
    expect(alone.leafCount).toBe(clumps.size[7]);
    expect(alone.levels.slice(0, 2).map(({ count }) => count)).toEqual([0, 0]);
    const all = Array.from({ length: clumps.count }, (_, c) => clumpTree(packed, clumps, c).levels[2]!.count);
    expect(all.reduce((a, b) => a + b)).toBe(packed.levels[2]!.count);
  });

  test('of a tree without leaves are clumps of its twigs', () => {
    const bare = clumpsOf({ ...packed, leafCount: 0 });
    expect(bare.count).toBeGreaterThanOrEqual(60);
    expect(bare.size.reduce((a, b) => a + b)).toBe(
      packed.pieceCount - packed.levels[0]!.count - packed.levels[1]!.count,
    );
  });
});
