import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { bezierArcLength } from '../../../src/core/math/bezier.ts';
import { distance, dot, subtract, unit } from '../../../src/core/math/vec3.ts';
import { PIECE_LAYERS } from '../../../src/core/pack/layout.ts';
import { layerStart } from '../../../src/core/pack/texel-array.ts';
import { type WindState, windStateAt } from '../../../src/core/wind/fade.ts';
import { planeOf, poseOf, poseTreePlainly } from '../../../src/core/wind/pose-plainly.ts';
import { poseTree } from '../../../src/core/wind/pose-tree.ts';
import { presets } from '../../../src/core/wind/presets.ts';
import { type SmallTree, smallTree } from './small-tree.ts';

const windAt = (name: string, time: number, change: Partial<WindState> = {}): WindState => ({
  ...windStateAt(presets[name], time),
  ...change,
});

const gale = windAt('gale', 3.7);
const tree = smallTree(300, 7);
const plane = planeOf(tree.restPose);

/** Largest difference of two poses in any number of any piece. */
const apart = (a: Float32Array, b: Float32Array): number => a.reduce((m, x, i) => Math.max(m, Math.abs(x - b[i])), 0);

/** A wind that is strong on every branch, whatever its length. */
const storm = windAt('gale', 3.7, { lengthExponent: 0 });
storm.waves = storm.waves.map((x, i) => (i % 4 === 2 ? 4 * x : x));

describe('the pose of a tree', () => {
  test('without wind is the rest pose', () => {
    expect(apart(poseTree(tree, windAt('still', 5), 'exact'), tree.restPose.data)).toBeLessThan(2e-5);
  });

  test('moves in the wind, and the root stays', () => {
    const pose = poseTree(tree, gale, 'exact');
    expect(apart(pose, tree.restPose.data)).toBeGreaterThan(0.1);
    expect(poseOf(pose, plane, 0).curve.p0).toEqual([2, 1, 0.5]);
  });

  test.each([
    ['gale', gale],
    ['a storm', storm],
    ['other exponents', windAt('gale', 8, { forceExponent: 1.8, lengthExponent: 2 })],
    ["the paper's forms", windAt('breeze', 8, { paper: true })],
  ])('fast and plain code agree: %s', (_, wind) => {
    for (const mode of ['exact', 'lagged'] as const) {
      expect(apart(poseTree(tree, wind, mode), poseTreePlainly(tree, wind, mode))).toBeLessThan(2e-6);
    }
  });

  test('keeps every arc length', () => {
    const pose = poseTree(tree, storm, 'exact');
    const arc = layerStart(tree.pieces, PIECE_LAYERS.END);
    for (let i = 0; i < tree.pieceCount; i++) {
      const rest = tree.pieces.data[arc + 4 * i + 3];
      expect(Math.abs(bezierArcLength(poseOf(pose, plane, i).curve) / rest - 1)).toBeLessThan(1e-4);
    }
  });

  test('keeps the chains whole: the next piece starts where the last ends and goes on in its direction', () => {
    const chained = tree.plan.flatMap((p, i) => (p.next ? [i] : []));
    expect(chained.length).toBeGreaterThan(20);
    for (const wind of [gale, storm]) {
      const pose = poseTree(tree, wind, 'exact');
      for (const i of chained) {
        const [a, b] = [poseOf(pose, plane, tree.plan[i].parent), poseOf(pose, plane, i)];
        expect(distance(a.curve.p3, b.curve.p0)).toBeLessThan(1e-5);
        const [end, start] = [subtract(a.curve.p3, a.curve.p2), subtract(b.curve.p1, b.curve.p0)];
        expect(distance(unit(end), unit(start))).toBeLessThan(1e-5);
      }
    }
  });

  test('keeps O a unit vector at right angles to the first edge', () => {
    const pose = poseTree(tree, storm, 'exact');
    for (let i = 0; i < tree.pieceCount; i++) {
      const { curve, o } = poseOf(pose, plane, i);
      expect(Math.abs(dot(o, o) - 1)).toBeLessThan(1e-5);
      expect(Math.abs(dot(o, unit(subtract(curve.p1, curve.p0))))).toBeLessThan(1e-5);
    }
  });

  test('lagged: in a steady wind depth d is exact after d + 1 steps, and not before', () => {
    const exact = poseTree(tree, gale, 'exact');
    let pose = tree.restPose.data;
    for (let step = 1; step <= tree.maxDepth + 1; step++) {
      pose = poseTree(tree, gale, 'lagged', pose);
      const settled = tree.plan.flatMap((p, i) => (p.depth < step ? [i] : []));
      for (const i of settled) {
        expect(distance(poseOf(pose, plane, i).curve.p3, poseOf(exact, plane, i).curve.p3)).toBeLessThan(1e-5);
      }
      if (step <= 3) expect(apart(pose, exact)).toBeGreaterThan(0.01);
    }
    expect(apart(pose, exact)).toBeLessThan(1e-5);
  });

  test('says how far a piece bends', () => {
    const pose = poseTree(tree, gale, 'exact');
    const angles = tree.plan.map((_, i) => poseOf(pose, plane, i).angle);
    expect(Math.min(...angles)).toBeGreaterThanOrEqual(0);
    expect(Math.max(...angles)).toBeGreaterThan(0.05);
    expect(
      Math.max(
        ...poseTree(tree, windAt('still', 0), 'exact')
          .slice(3 * plane)
          .filter((_, i) => i % 4 === 3),
      ),
    ).toBeLessThan(1e-6);
  });

  test('has no NaN in any wind', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 1, max: 1e6 }),
        fc.constantFrom(...Object.keys(presets)),
        fc.double({ min: 0, max: 1e7, noNaN: true }),
        fc.constantFrom(0, 1, 1e3, 1e6),
        fc.constantFrom(1, 1.8, 3),
        fc.constantFrom(0, 0.6, 1, 2),
        fc.boolean(),
        (seed, name, time, gain, forceExponent, lengthExponent, paper) => {
          const small: SmallTree = smallTree(12, seed);
          const wind = windAt(name, time, { forceExponent, lengthExponent, paper: paper && gain < 1e3 });
          wind.waves = wind.waves.map((x, i) => (i % 4 === 2 ? gain * x : x));
          expect(poseTree(small, wind, 'exact').every(Number.isFinite)).toBe(true);
        },
      ),
    );
  });
});
