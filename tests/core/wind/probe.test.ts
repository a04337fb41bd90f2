import { describe, expect, test } from 'vitest';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { POSE_TARGETS } from '../../../src/core/pack/layout.ts';
import type { PackedTree } from '../../../src/core/pack/packed.ts';
import { layerStart } from '../../../src/core/pack/texel-array.ts';
import { createWindState, type WindState, windStateAt } from '../../../src/core/wind/fade.ts';
import { windForce } from '../../../src/core/wind/force.ts';
import { poseTree } from '../../../src/core/wind/pose-tree.ts';
import { Probe, type ProbeWind } from '../../../src/core/wind/probe.ts';
import { chainOf, piecesTo } from '../../../src/core/wind/probe-chain.ts';
import type { ProbeReading } from '../../../src/core/wind/probe-history.ts';
import { defaultPiece, indexPieces, placeOfPiece } from '../../../src/core/wind/probe-place.ts';
import { ProbeRecorder } from '../../../src/core/wind/probe-recorder.ts';
import { SpringRun } from '../../../src/core/wind/spring-run.ts';
import { swayTexels } from '../../../src/core/wind/sway.ts';
import type { Wind } from '../../../src/core/wind/wind.ts';
import { shippedSpecies } from '../pack/shipped-species.ts';
import { GALE } from './some-winds.ts';

const { packed } = growPacked({ ...shippedSpecies('quaking-aspen') }, 3, { levels: 3 });
const index = indexPieces(packed);
const limb = defaultPiece(packed, index);
const twig = packed.pieceCount - 1;

const blowing = (wind: Wind): ProbeWind => ({
  wind,
  at: (time: number, out: WindState) => windStateAt(wind, time, undefined, out),
});
const nothing = (): ProbeReading => ({ fx: 0, fy: 0, x: 0, y: 0, z: 0 });
const readings = (probe: Probe, steps: readonly number[]): ProbeReading[] =>
  steps.map((step) => ({ ...probe.read(step, nothing()) }));

/** End of a piece in a pose of the whole tree. */
const endOf = (pose: Float32Array, tree: PackedTree, piece: number): number[] => {
  const at = layerStart(tree.restPose, POSE_TARGETS.P3) + 4 * piece;
  return [...pose.subarray(at, at + 3)];
};

describe('the chain of a piece', () => {
  test('runs from a root to the piece, each the parent of the next', () => {
    const chain = piecesTo(packed, twig);
    expect(chain[chain.length - 1]).toBe(twig);
    expect(chain[0]).toBe(0);
    for (let k = 1; k < chain.length; k++) expect(packed.pieces.data[4 * chain[k]]).toBe(chain[k - 1]);
    expect(chainOf(packed, twig).pieceCount).toBe(chain.length);
    expect(() => chainOf(packed, packed.pieceCount)).toThrow(RangeError);
  });
});

describe.each(['direct', 'spring', 'sway'] as const)('a probe in a wind of the model %s', (model) => {
  const wind: Wind = { ...GALE, model };

  test('has the end where the whole tree has it, bit for bit', () => {
    const run = new SpringRun(packed, (time, out) => void windStateAt(wind, time, undefined, out));
    const sway = swayTexels(packed, wind.sway);
    for (const piece of [limb, twig]) {
      const probe = new Probe(packed, piece, blowing(wind));
      for (const step of [0, 1, 40]) {
        const state = windStateAt(wind, step / 60);
        const bends = { sway, ...(model === 'spring' ? run.bendsAt(step / 60) : {}) };
        const end = endOf(poseTree(packed, state, 'exact', undefined, undefined, bends), packed, piece);
        const rest = endOf(packed.restPose.data, packed, piece);
        const { x, y, z, fx, fy } = probe.read(step, nothing());
        expect([x, y, z]).toEqual(end.map((value, k) => value - rest[k]));
        const tip = layerStart(packed.pieces, 4) + 4 * piece;
        const { data } = packed.pieces;
        expect([fx, fy]).toEqual(windForce(state, data[tip], data[tip + 1], data[tip + 2]));
        expect(probe.endAt(step / 60)).toEqual(end);
      }
      run.restart();
    }
  });

  test('says the same whatever was asked before', () => {
    const steps = [0, 1, 2, 50, 51, 200];
    const forwards = readings(new Probe(packed, twig, blowing(wind)), steps);
    const backwards = readings(new Probe(packed, twig, blowing(wind)), steps.toReversed()).toReversed();
    expect(backwards).toEqual(forwards);
    expect(new Set(forwards.map(({ x }) => x)).size).toBe(steps.length);
  });
});

test('a lagged probe hears of its parents a step late, and a jump does not change what it says', () => {
  const wind: Wind = { ...GALE, model: 'direct', pose: 'lagged' };
  const played = new Probe(packed, twig, blowing(wind));
  const all = readings(
    played,
    Array.from({ length: 60 }, (_, k) => k),
  );
  expect(readings(new Probe(packed, twig, blowing(wind)), [59])[0]).toEqual(all[59]);
  const exact = readings(new Probe(packed, twig, blowing({ ...wind, pose: 'exact' })), [59])[0];
  expect(exact.x).not.toBe(all[59].x);
  expect(played.endAt(1)).toBeNull();
});

test('the springs of a far time begin ten minutes earlier, and have settled by then', () => {
  const wind: Wind = { ...GALE, model: 'spring' };
  const far = 720 * 60;
  const [whole] = readings(new Probe(packed, limb, blowing(wind)), [600 * 60]);
  expect(Math.hypot(whole.x, whole.y)).toBeGreaterThan(1e-3);
  const probe = new Probe(packed, limb, blowing(wind));
  let looks = 0;
  while (!probe.prepare(far, () => false)) looks++;
  expect(looks).toBeGreaterThan(100);
  const late = probe.read(far, nothing());
  const run = new SpringRun(chainOf(packed, limb), (time, out) => void windStateAt(wind, time, undefined, out));
  const chain = chainOf(packed, limb);
  const pose = poseTree(chain, windStateAt(wind, 720), 'exact', undefined, undefined, run.bendsAt(720));
  const end = endOf(pose, chain, chain.pieceCount - 1);
  const rest = endOf(packed.restPose.data, packed, limb);
  expect(Math.abs(late.x - (end[0] - rest[0]))).toBeLessThan(1e-6);
});

describe('a recorder', () => {
  const wind: Wind = { ...GALE, model: 'spring' };
  const recorder = (): ProbeRecorder => new ProbeRecorder(new Probe(packed, limb, blowing(wind)));
  const along = (r: ProbeRecorder): number[] => [...r.history.column('along', 0)];

  test('comes to the same history by playing, by a jump, and by a jump in slices', () => {
    const played = recorder();
    for (let step = 0; step <= 400; step++) expect(played.follow(step)).toBe(1);
    const jumped = recorder();
    expect(jumped.follow(400)).toBe(1);
    const sliced = recorder();
    let turns = 0;
    let left = 0;
    while (sliced.follow(400, () => left-- > 0) < 1) {
      left = 30;
      turns++;
    }
    expect(turns).toBeGreaterThan(5);
    expect(played.history.count).toBe(401);
    expect(along(jumped)).toEqual(along(played));
    expect(along(sliced)).toEqual(along(played));
  });

  test('keeps what it has where time goes back, and goes on from there as before', () => {
    const once = recorder();
    once.follow(300);
    const back = recorder();
    back.follow(300);
    expect(back.follow(200)).toBe(1);
    expect(back.history.last).toBe(200);
    back.follow(300);
    expect(along(back)).toEqual(along(once));
  });

  test('forgets a past that has nothing to do with now', () => {
    const r = recorder();
    r.follow(100);
    r.follow(5000);
    expect([r.history.first, r.history.last]).toEqual([5000 - 3600, 5000]);
    r.follow(20);
    expect([r.history.first, r.history.last]).toEqual([0, 20]);
    r.forget();
    expect(r.history.count).toBe(0);
  });
});

describe('where a probe sits', () => {
  test('at first: the end of a limb about half way up', () => {
    const place = placeOfPiece(packed, index, limb);
    expect(place.level).toBe(1);
    expect(place.z1).toBeCloseTo(1, 5);
    const height = packed.bounds[5] - packed.bounds[2];
    expect(place.height / height).toBeGreaterThan(0.3);
    expect(place.height / height).toBeLessThan(0.75);
  });

  test('every piece has the level of the range that draws it', () => {
    packed.levels.forEach(({ start, count }, level) => {
      for (const place of [start, start + count - 1]) {
        const piece = packed.branches.data[4 * place];
        expect([index.level[piece], index.place[piece]]).toEqual([level, place]);
      }
    });
  });
});

test('its natural frequency is that of its stem, with the factor of the wind', () => {
  const one = new Probe(packed, limb, blowing({ ...GALE, model: 'spring' }));
  const two = new Probe(packed, limb, blowing({ ...GALE, model: 'spring', spring: { ...GALE.spring, frequency: 2 } }));
  expect(one.natural).toBeGreaterThan(0.05);
  expect(two.natural).toBeCloseTo(2 * one.natural, 9);
});

test('asking costs no state that others share', () => {
  const out = createWindState();
  const probe = new Probe(packed, limb, {
    wind: GALE,
    at: (time, into) => windStateAt(GALE, time, undefined, into ?? out),
  });
  probe.read(7, nothing());
  expect(out.time).toBe(0);
});
