import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { arcLength } from '../../../src/core/math/bezier.ts';
import { distance, dot, subtract, unit } from '../../../src/core/math/vec3.ts';
import { PIECE_LAYERS } from '../../../src/core/pack/layout.ts';
import { layerStart } from '../../../src/core/pack/texel-array.ts';
import { type WindState, windStateAt } from '../../../src/core/wind/fade.ts';
import { windForce } from '../../../src/core/wind/force.ts';
import { planeOf, poseOf, poseTreePlainly, restPieceOf } from '../../../src/core/wind/pose-plainly.ts';
import { poseTree } from '../../../src/core/wind/pose-tree.ts';
import { SpringRun } from '../../../src/core/wind/spring-run.ts';
import { swayTexels } from '../../../src/core/wind/sway.ts';
import { bentTree } from './bent-tree.ts';
import { directWind, windNames } from './shipped-winds.ts';
import { type SmallTree, smallTree } from './small-tree.ts';
import { GALE, galeOf, stateOf } from './some-winds.ts';

const windAt = (name: string, time: number, change: Partial<WindState> = {}): WindState => ({
  ...windStateAt(directWind(name), time),
  ...change,
});

const gale = windAt('gale', 3.7);
const tree = smallTree(300, 7);
const plane = planeOf(tree.restPose);

/** A tree whose stems are springs, and what its pose needs of them. */
const bent = bentTree(300, 7);
const running = new SpringRun(bent, (time, out) => {
  windStateAt(GALE, time, undefined, out);
});
const bends = { ...running.bendsAt(4), sway: swayTexels(bent, GALE.sway) };

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
      expect(apart(poseTree(tree, wind, mode), poseTreePlainly(tree, wind, mode))).toBeLessThan(1e-5);
    }
  });

  test.each([
    ['spring', { model: 'spring' }],
    ['sway', { model: 'sway' }],
    ['spring fading into sway', { model: 'sway', from: 'spring', modelFade: 0.3 }],
    ['direct fading into spring', { model: 'spring', from: 'direct', modelFade: 0.6 }],
    ["springs in the paper's form", { model: 'spring', paper: true }],
  ] as const)('fast and plain code agree: %s', (_, change) => {
    const wind = stateOf(galeOf(0.2), 4, { softness: 0.8, ...change });
    const pose = (pose: typeof poseTree) => pose(bent, wind, 'exact', undefined, undefined, bends);
    expect(apart(pose(poseTree), pose(poseTreePlainly))).toBeLessThan(2e-5);
    expect(apart(pose(poseTree), bent.restPose.data)).toBeGreaterThan(0.02);
  });

  test('a fade starts in the one model and ends in the other', () => {
    const pose = (change: Partial<WindState>) =>
      poseTree(bent, stateOf(GALE, 4, change), 'exact', undefined, undefined, bends);
    const [from, to] = [pose({ model: 'direct' }), pose({ model: 'sway' })];
    expect(apart(pose({ model: 'sway', from: 'direct', modelFade: 0 }), from)).toBeLessThan(1e-6);
    expect(apart(pose({ model: 'sway', from: 'direct', modelFade: 1 }), to)).toBeLessThan(1e-6);
    expect(apart(from, to)).toBeGreaterThan(0.1);
  });

  test('softness bends twice as far where it is twice as much, and 0 not at all', () => {
    const points = (pose: Float32Array) => pose.filter((_, i) => i % 4 < 3);
    const rest = points(tree.restPose.data);
    const pose = (softness: number) => points(poseTree(tree, { ...gale, softness }, 'exact'));
    expect(apart(pose(0), rest)).toBeLessThan(2e-5);
    expect(apart(pose(0.02), rest) / apart(pose(0.01), rest)).toBeCloseTo(2, 1);
  });

  test('keeps every arc length', () => {
    const pose = poseTree(tree, storm, 'exact');
    const arc = layerStart(tree.pieces, PIECE_LAYERS.END);
    for (let i = 0; i < tree.pieceCount; i++) {
      const rest = tree.pieces.data[arc + 4 * i + 3];
      expect(Math.abs(arcLength(poseOf(pose, plane, i).curve) / rest - 1)).toBeLessThan(1e-4);
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

  test('says how hard the leaves are shaken: by the force, and for springs by their own way too', () => {
    const stirOf = (pose: Float32Array) => tree.plan.map((_, i) => poseOf(pose, plane, i).stir);
    expect(Math.max(...stirOf(poseTree(tree, windAt('still', 0), 'exact')))).toBe(0);
    const direct = stirOf(poseTree(tree, gale, 'exact'));
    tree.plan.forEach((_, i) => {
      expect(direct[i]).toBeCloseTo(Math.hypot(...windForce(gale, ...restPieceOf(tree, i).tip)), 6);
    });
    const run = new SpringRun(bent, (time, out) => {
      windStateAt(GALE, time, undefined, out);
    });
    const springs = run.bendsAt(7).springs;
    const sprung = stirOf(poseTree(bent, stateOf(GALE, 7), 'exact', undefined, undefined, { springs }));
    const force = springs.state.slice(planeOf(springs.texels));
    bent.plan.forEach((_, i) => {
      expect(sprung[i]).toBeGreaterThanOrEqual(force[4 * i + 3]);
    });
    expect(Math.max(...sprung)).toBeGreaterThan(Math.max(...direct) / 10);
  });

  test('has no NaN in any wind', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 1, max: 1e6 }),
        fc.constantFrom(...windNames),
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
