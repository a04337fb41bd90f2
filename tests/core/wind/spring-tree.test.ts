import { describe, expect, test } from 'vitest';
import { matrixFromQuaternion } from '../../../src/core/math/quaternion.ts';
import { mix, type Vec3 } from '../../../src/core/math/vec3.ts';
import { MECHANICS, MECHANICS_SIZE, SPRING_LAYERS, STATE_TARGETS } from '../../../src/core/pack/layout.ts';
import { layerStart } from '../../../src/core/pack/texel-array.ts';
import { bendVector } from '../../../src/core/wind/bend.ts';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import { windForce } from '../../../src/core/wind/force.ts';
import { restPieceOf } from '../../../src/core/wind/pose-plainly.ts';
import { poseTree } from '../../../src/core/wind/pose-tree.ts';
import { springFrame, springOf } from '../../../src/core/wind/push.ts';
import { type Spring, springStart, springStep, springTarget, type Transition } from '../../../src/core/wind/spring.ts';
import { type FillWind, SpringRun } from '../../../src/core/wind/spring-run.ts';
import { springDamping, springOmega, springTexels } from '../../../src/core/wind/spring-texels.ts';
import { startSprings, stepSprings } from '../../../src/core/wind/spring-tree.ts';
import { STILL, type Wind } from '../../../src/core/wind/wind.ts';
import { bentTree } from './bent-tree.ts';
import { BEAUFORT_11, GALE, galeOf, stateOf, steady } from './some-winds.ts';

const tree = bentTree(120, 5);
const texels = springTexels(tree, STILL.spring);
const plane = layerStart(texels, 1);
const fill =
  (wind: Wind): FillWind =>
  (time, out) => {
    windStateAt(wind, time, undefined, out);
  };
const apart = (a: Float32Array, b: Float32Array): number =>
  a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i])), 0);

describe('texels', () => {
  test('hold orthonormal frames at rest', () => {
    for (let i = 0; i < tree.pieceCount; i++) {
      const [l, t, s] = springFrame(texels, i);
      const one = l[0] * t[0] + l[1] * t[1] + l[2] * t[2];
      expect(Math.abs(one)).toBeLessThan(1e-6);
      expect(Math.abs(Math.hypot(...s) - 1)).toBeLessThan(1e-6);
    }
  });

  test('settings change frequency and damping: all, by stiffness, and by level', () => {
    const { spring } = STILL;
    const piece = tree.plan.findIndex(({ depth }) => depth === 3);
    const grown = tree.mechanics[MECHANICS_SIZE * piece + MECHANICS.OMEGA];
    expect(springOmega(tree, piece, spring)).toBeCloseTo(grown, 5);
    expect(springOmega(tree, piece, { ...spring, frequency: 2 })).toBeCloseTo(2 * grown, 5);
    expect(springOmega(tree, piece, spring, 4)).toBeCloseTo(2 * grown, 5);
    const level = tree.mechanics[MECHANICS_SIZE * piece + MECHANICS.LEVEL];
    const levels = Array.from({ length: level + 1 }, () => ({ frequency: null, damping: null as number | null }));
    levels[level] = { frequency: 1.5 as never, damping: 0.7 };
    const own = { ...spring, frequency: 3, levels };
    expect(springOmega(tree, piece, own, 4)).toBeCloseTo(3 * Math.PI, 9);
    expect(springDamping(tree, piece, own)).toBe(0.7);
    expect(springDamping(tree, 0, own)).toBe(spring.damping);
    const dull = { mechanics: tree.mechanics.map((x, i) => (i % MECHANICS_SIZE === MECHANICS.DAMPING ? 1.5 : x)) };
    expect(springDamping(dull, 0, own)).toBeCloseTo(1.5 * spring.damping, 6);
    expect(springDamping(dull, piece, own)).toBe(0.7);
    // Fewer entries than levels: the rest is as grown.
    expect(springOmega(tree, piece, { ...spring, levels: [{ frequency: 9, damping: null }] })).toBeCloseTo(grown, 5);
  });

  test('the pieces of a chain reach as far together as their stem alone', () => {
    const next = tree.plan.findIndex((p) => p.next);
    const at = MECHANICS_SIZE * next;
    const { LENGTH, PHASE } = MECHANICS;
    const load = SPRING_LAYERS.LOAD * plane;
    // The pieces of a stem have its phase.
    const chain = tree.plan.flatMap((_, i) =>
      tree.mechanics[MECHANICS_SIZE * i + PHASE] === tree.mechanics[at + PHASE] ? [i] : [],
    );
    expect(chain.length).toBeGreaterThan(1);
    const together = chain.reduce((sum, i) => sum + texels.data[load + 4 * i + 1], 0);
    expect(together).toBeCloseTo(tree.mechanics[at + LENGTH] / 2.8, 5);
  });
});

describe('a step of a whole tree', () => {
  /** The same, function by function. */
  function plainly(previous: Float32Array | null, wind = stateOf(GALE, 3)): Spring[] {
    return tree.plan.map(({ parent, v }, i) => {
      const { rest, tip } = restPieceOf(tree, i);
      const frame = springFrame(texels, i);
      const [fx, fy] = windForce(wind, ...tip);
      const beta = bendVector(fx, fy, rest.third, wind.forceExponent, wind.lengthExponent);
      const force = Math.hypot(fx, fy);
      if (!previous) return springStart(springTarget(frame, beta, [0, 0, 0], 0), force);
      const load = SPRING_LAYERS.LOAD * plane + 4 * i;
      let base: Vec3 = [0, 0, 0];
      if (parent >= 0) {
        const above = springOf(previous, plane, parent);
        base = mix(above.base, above.end, Math.fround(v));
      }
      const target = springTarget(frame, beta, base, texels.data[load] * wind.spring.inertia);
      const step = SPRING_LAYERS.STEP * plane + 4 * i;
      const transition = [...texels.data.subarray(step, step + 4)] as Transition;
      return springStep(springOf(previous, plane, i), target, transition, frame, base, texels.data[load + 1], force);
    });
  }

  test('is that of every piece, from the start on', () => {
    let state = startSprings(tree, texels, stateOf(GALE, 0));
    const compare = (springs: Spring[]) =>
      springs.forEach((want, i) => {
        const got = springOf(state, plane, i);
        for (const key of ['q', 'velocity', 'base', 'end'] as const) {
          got[key].forEach((x, k) => {
            expect(Math.abs(x - want[key][k])).toBeLessThan(2e-5 * Math.max(1, Math.abs(x)));
          });
        }
        expect(got.force).toBeCloseTo(want.force, 6);
        expect(got.along).toBeCloseTo(want.along, 6);
      });
    compare(plainly(null, stateOf(GALE, 0)));
    for (let n = 0; n < 200; n++) {
      const wind = stateOf(GALE, (n + 0.5) / 60);
      const springs = n % 40 === 0 ? plainly(state, wind) : undefined;
      state = stepSprings(tree, texels, wind, state);
      if (springs) compare(springs);
    }
  });

  test('children are shaken by their parents, and roots by nothing', () => {
    const run = new SpringRun(tree, fill(galeOf(0.4)));
    const state = run.stepTo(90);
    const base = STATE_TARGETS.BASE * plane;
    expect(state.subarray(base, base + 3).every((x) => x === 0)).toBe(true);
    const shaken = tree.plan.filter((_, i) => Math.abs(state[base + 4 * i]) > 0.05);
    expect(shaken.length).toBeGreaterThan(0.5 * tree.pieceCount);
  });
});

describe('a run', () => {
  test('at rest in a steady wind has the pose of the direct model', () => {
    const wind = steady(0.15, 30);
    const run = new SpringRun(tree, fill({ ...wind, model: 'spring' }));
    const direct = poseTree(tree, stateOf({ ...wind, model: 'direct' }, 0), 'exact');
    for (const time of [0, 5]) {
      const sprung = poseTree(tree, stateOf(wind, time), 'exact', undefined, undefined, run.bendsAt(time));
      expect(apart(sprung, direct)).toBeLessThan(1e-5);
    }
  });

  test('comes to that pose from another one', () => {
    const run = new SpringRun(tree, fill(steady(0.02)));
    run.stepTo(10);
    run.edit(fill(steady(0.15, 30)));
    const direct = poseTree(tree, stateOf(steady(0.15, 30, { model: 'direct' }), 0), 'exact');
    const poseAt = (time: number) =>
      poseTree(tree, stateOf(steady(0.15, 30), time), 'exact', undefined, undefined, run.bendsAt(time));
    expect(apart(poseAt(11 / 60), direct)).toBeGreaterThan(0.05);
    expect(apart(poseAt(60), direct)).toBeLessThan(1e-4);
  });

  test('sought is the run played, bit for bit', () => {
    const played = new SpringRun(tree, fill(GALE), { checkpoints: 4 });
    const states = new Map<number, Float32Array>();
    for (let n = 0; n <= 700; n++) {
      const state = played.stepTo(n);
      if (n % 50 === 0 || n === 333) states.set(n, state.slice());
    }
    expect(played.kept.length).toBeLessThanOrEqual(4);
    const sought = new SpringRun(tree, fill(GALE));
    for (const n of [700, 333, 0, 650, 50, 600]) expect(sought.stepTo(n)).toEqual(states.get(n));
    // Back in the run that was played, by a checkpoint and by the step before.
    expect(played.stepTo(699)).toEqual(new SpringRun(tree, fill(GALE)).stepTo(699));
    for (const n of [333, 50, 0]) expect(played.stepTo(n)).toEqual(states.get(n));
  });

  test('between two steps lies between them, and on a step is that step', () => {
    const run = new SpringRun(tree, fill(GALE));
    const [a, b] = [run.stepTo(100).slice(), run.stepTo(101).slice()];
    const mixed = run.at(100.25 / 60).slice();
    mixed.forEach((x, i) => {
      expect(Math.abs(x - (0.75 * a[i] + 0.25 * b[i]))).toBeLessThan(1e-4 * Math.max(1, Math.abs(x)));
    });
    expect(run.at(100 / 60)).toEqual(a);
    expect(run.at(101 / 60)).toEqual(b);
    const other = new SpringRun(tree, fill(GALE));
    expect(other.at(100.25 / 60)).toEqual(mixed);
    expect(other.at(-3)).toEqual(new SpringRun(tree, fill(GALE)).stepTo(0));
  });

  test('an edit goes on from the state there is; seeking back is the new wind from the start', () => {
    const run = new SpringRun(tree, fill(GALE));
    const before = run.stepTo(200).slice();
    run.edit(fill(steady(0.1)));
    expect(run.stepTo(200)).toEqual(before);
    expect(run.pure).toBe(false);
    // Nothing jumps: one step moves every bend by its velocity at most.
    const after = run.stepTo(201);
    for (let i = 0; i < 4 * tree.pieceCount; i += 4) expect(Math.abs(after[i] - before[i])).toBeLessThan(0.2);
    const fresh = new SpringRun(tree, fill(steady(0.1)));
    expect(run.stepTo(20)).toEqual(fresh.stepTo(20));
    expect(run.pure).toBe(true);
    run.restart(fill(GALE));
    expect(run.stepTo(200)).toEqual(before);
  });

  test('stays bounded through ten minutes of storm, and falls still without wind', () => {
    const few = bentTree(24, 3);
    const storm = galeOf(3 * BEAUFORT_11);
    const run = new SpringRun(few, fill(storm), { checkpoints: 2 });
    let most = 0;
    for (let n = 0; n < 36_000; n += 97) {
      const state = run.stepTo(n);
      for (let i = 0; i < state.length; i++) most = Math.max(most, Math.abs(state[i]));
    }
    expect(Number.isFinite(most)).toBe(true);
    expect(most).toBeLessThan(5000);
    run.edit(fill({ ...storm, strength: 0 }));
    const still = run.stepTo(36_000 + 60 * 60);
    expect(still.every((x) => Math.abs(x) < 1e-4)).toBe(true);
  });

  test('without wind its energy never grows, whatever moves: the cascade feeds nothing back', () => {
    const run = new SpringRun(tree, fill(GALE));
    const running = run.stepTo(300);
    run.edit(fill({ ...GALE, strength: 0 }));
    // Energy of the roots alone, which nothing shakes.
    const energy = (state: Float32Array): number => {
      const omega = texels.data[SPRING_LAYERS.LOAD * plane + 2];
      return omega ** 2 * (state[0] ** 2 + state[1] ** 2) + state[2] ** 2 + state[3] ** 2;
    };
    let last = energy(running);
    for (let n = 301; n < 900; n++) {
      const now = energy(run.stepTo(n));
      expect(now).toBeLessThanOrEqual(last * (1 + 1e-6));
      last = now;
    }
    const all = run.stepTo(6000);
    expect(all.every((x) => Math.abs(x) < 1e-5)).toBe(true);
  });
});

test('matrixFromQuaternion gives the frame that the step writes out', () => {
  const [x, y, z, w] = texels.data.subarray(0, 4);
  expect(springFrame(texels, 0)).toEqual(matrixFromQuaternion([x, y, z, w]));
});
