import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { sameBefore, WindFader, type WindState, windStateAt } from '../../../src/core/wind/fade.ts';
import { windForce } from '../../../src/core/wind/force.ts';
import type { BendModelName, Gust, Wind, WindRecord } from '../../../src/core/wind/wind.ts';
import { anyWind, breeze, gale, gust } from './any-winds.ts';

const still = { ...breeze, strength: 0 };
const place = { x: 12, y: 30, yaw: 1 };
const forceIn = (state: WindState): [number, number] => windForce(state, 1, 2, 4);
const forceOf = (fader: WindFader, time: number): [number, number] => forceIn(fader.at(time, place));
const steady = (wind: Wind, time: number): [number, number] => forceIn(windStateAt(wind, time, place));
const apart = (a: [number, number], b: [number, number]): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
const twice = <T extends { amplitude: number }>(of: T): T => ({ ...of, amplitude: 2 * of.amplitude });

/** How strongly a bend model is heard. */
const weightOf = ({ model, from, modelFade }: WindState, name: BendModelName): number =>
  (model === name ? modelFade : 0) + (from === name ? 1 - modelFade : 0);

/** All that must not jump, as numbers: force, factors, the weights of the models, and what sways at which frequency. */
function heard(state: WindState): number[] {
  const { sway } = state;
  const swinging = weightOf(state, 'sway') * state.loudness;
  const frequencies = (['ratio', 'cantilever'] as const).flatMap((reading) =>
    [1 / 15, 67].map((rate) => (sway.reading === reading && sway.rate === rate ? swinging : 0)),
  );
  return [
    ...forceIn(state),
    state.softness,
    state.forceExponent,
    state.lengthExponent,
    ...(['direct', 'spring', 'sway'] as const).map((name) => weightOf(state, name)),
    ...frequencies.flatMap((weight) => [weight * (sway.speed / 50), weight * (sway.gust / 50)]),
  ];
}

const most = (a: readonly number[], b: readonly number[]): number =>
  Math.max(...a.map((n, i) => Math.abs(n - (b[i] as number))));

const anyEdits = fc.array(fc.tuple(anyWind, fc.double({ min: 0.02, max: 1.5, noNaN: true })), {
  minLength: 1,
  maxLength: 6,
});

describe('fading', () => {
  test('no edit makes anything jump: not at once, not amid a fade, not at its end', () => {
    const moment = 1e-6;
    // What sixteen waves, gusts, a record and a fade of half a second change in two such moments; and that float32 rounds.
    const limit = 2 * moment * 400 + 2e-6;
    fc.assert(
      fc.property(anyWind, anyEdits, (first, edits) => {
        const fader = new WindFader(first);
        let [time, end, waiting, jump] = [100, 0, false, 0];
        let seams: number[] = [];
        const check = (until: number) => {
          for (const seam of seams.filter((s) => s < until).sort((a, b) => a - b)) {
            const [before, after] = [seam - moment, seam + moment].map((t) => heard(fader.at(t, place)));
            jump = Math.max(jump, most(before as number[], after as number[]));
          }
          seams = seams.filter((s) => s >= until);
        };
        for (const [wind, wait] of edits) {
          const before = heard(fader.at(time, place));
          fader.set(wind, time, 0.5);
          jump = Math.max(jump, most(heard(fader.at(time, place)), before));
          // An edit during a fade begins at its end.
          if (waiting && time >= end) [waiting, end] = [false, end + 0.5];
          if (time < end) waiting = true;
          const start = waiting ? end : time;
          if (!waiting) end = time + 0.5;
          seams.push(start, start + 0.25, start + 0.5);
          check(time + wait);
          time += wait;
        }
        check(Number.POSITIVE_INFINITY);
        expect(jump).toBeLessThan(limit);
      }),
      { numRuns: 400 },
    );
  });

  test('nor does it in between', () => {
    const dt = 1 / 1000;
    // Eight waves of 0.3 m: 2.5 turns a second times a slope of at most pi sqrt(k); gusts; a record; two such winds, whose profiles give a
    // factor of up to 4 there, that cross-fade within half a second or more.
    const limit = dt * 4 * (8 * 0.3 * 2.5 * Math.PI * 2 + 6 + 3 + (1.5 / 0.5) * 2 * 4.5);
    fc.assert(
      fc.property(anyEdits, (edits) => {
        const fader = new WindFader(breeze);
        let [time, next, wait, jump] = [100, 0, 0.1, 0];
        let last = forceOf(fader, time);
        for (let i = 0; i < 3000; i++) {
          time += dt;
          wait -= dt;
          const edit = edits[next];
          if (wait <= 0 && edit) {
            fader.set(edit[0], time, 0.5);
            wait = edit[1];
            next++;
          }
          const force = forceOf(fader, time);
          jump = Math.max(jump, apart(force, last));
          last = force;
        }
        expect(jump).toBeLessThan(limit);
      }),
      { numRuns: 15, endOnFailure: true },
    );
  });

  test('ends in the wind that was asked for', () => {
    const fader = new WindFader(breeze);
    fader.set(gale, 10, 2);
    expect(apart(forceOf(fader, 10), steady(breeze, 10))).toBeLessThan(1e-7);
    expect(fader.fading(11)).toBe(true);
    expect(apart(forceOf(fader, 12), steady(gale, 12))).toBeLessThan(1e-7);
    expect(fader.fading(12)).toBe(false);
    expect(fader.at(12).count).toBe(4);
  });

  test('edits during a fade wait for its end; the latest wins', () => {
    const fader = new WindFader(breeze);
    fader.set(gale, 10, 2);
    fader.set(still, 10.5, 2);
    fader.set({ ...gale, name: 'last', strength: 0.3 }, 11, 2);
    expect(fader.target.name).toBe('last');
    const other = new WindFader(breeze);
    other.set(gale, 10, 2);
    expect(apart(forceOf(fader, 11.9), forceOf(other, 11.9))).toBeLessThan(1e-7);
    expect(apart(forceOf(fader, 14), steady({ ...gale, strength: 0.3 }, 14))).toBeLessThan(1e-7);
  });

  test('fades to nothing and back again', () => {
    const fader = new WindFader(breeze);
    fader.set(still, 0, 1);
    expect(fader.at(0.5).count).toBe(3);
    expect(apart(forceOf(fader, 0.5), steady({ ...breeze, strength: 0.5 }, 0.5))).toBeLessThan(1e-7);
    expect(fader.at(1).count).toBe(0);
    fader.set(breeze, 5, 1);
    expect(apart(forceOf(fader, 6), steady(breeze, 6))).toBeLessThan(1e-7);
  });

  test('at once where no seconds are given, and where the clock is sought back', () => {
    const fader = new WindFader(breeze);
    fader.set(gale, 10, 2);
    fader.set(still, 11, 0);
    expect(fader.at(11).count).toBe(0);
    fader.set(gale, 12, 2);
    expect(apart(forceOf(fader, 3), steady(gale, 3))).toBeLessThan(1e-7);
  });

  test('a step a little before the edit does not end its fade', () => {
    const fader = new WindFader(breeze);
    fader.set(gale, 10, 2);
    expect(apart(forceOf(fader, 9.98), steady(breeze, 9.98))).toBeLessThan(1e-7);
    expect(fader.fading(11)).toBe(true);
  });

  test('waves and gusts that differ in strength alone take one slot, wherever they stand; others two', () => {
    const fader = new WindFader({ ...gale, gusts: [gust] });
    fader.set({ ...gale, waves: gale.waves.map(twice).reverse(), gusts: [twice(gust)] }, 10, 1);
    const half = fader.at(10.5);
    expect([half.count, half.gustCount]).toEqual([4, 1]);
    expect(half.waves[4 * 3 + 2]).toBeCloseTo(1.5 * 0.22, 6);
    expect(half.gusts[2]).toBeCloseTo(1.5 * 0.2, 6);
    fader.set({ ...breeze, gusts: [{ ...gust, speed: 9 }] }, 12, 1);
    expect([fader.at(12.5).count, fader.at(12.5).gustCount]).toEqual([7, 2]);
  });

  test('a mean that is taken off fades', () => {
    const fader = new WindFader(gale);
    fader.set({ ...gale, zeroMean: true }, 0, 1);
    expect(fader.at(0.5).count).toBe(4);
    expect(fader.at(0.5).phases[2]).toBeCloseTo(0.375 / 2, 6);
    expect(fader.at(1).phases[2]).toBeCloseTo(0.375, 6);
  });

  test('exponents, softness and model fade too', () => {
    const fader = new WindFader(breeze);
    fader.set({ ...breeze, forceExponent: 1.8, lengthExponent: 2, stiffness: 4, model: 'spring' }, 0, 1);
    const half = fader.at(0.5);
    expect([half.forceExponent, half.lengthExponent]).toEqual([1.4, expect.closeTo(1.3, 12)]);
    expect(half.softness).toBeCloseTo(0.625, 12);
    expect([half.model, half.from, half.modelFade]).toEqual(['spring', 'direct', 0.5]);
    const after = fader.at(1);
    expect([after.model, after.from, after.modelFade]).toEqual(['spring', null, 1]);
  });

  test('one record passes into another through none: a texture holds one', () => {
    const a: WindRecord = { name: 'a', step: 1, speed: [3, 3], direction: [0, 0] };
    const fader = new WindFader({ ...still, strength: 1, waves: [], record: a });
    const from = fader.at(0).record;
    fader.set({ ...still, strength: 1, waves: [], record: { ...a, name: 'b', speed: [5, 5] } }, 0, 1);
    expect(fader.at(0.3).record).toBe(from);
    expect(fader.at(0.5).record).toBeNull();
    expect(fader.at(0.7).record).not.toBe(from);
    expect(forceOf(fader, 1)[0]).toBeCloseTo(steady(fader.target, 1)[0], 7);
  });
});

describe('the past', () => {
  const later: Wind = { ...breeze, gusts: [{ ...gust, start: 20 }] };

  test('is as it was while a fade goes on, and another when all is settled', () => {
    const fader = new WindFader(breeze);
    const { epoch } = fader;
    fader.set(gale, 10, 2);
    fader.at(13);
    expect(fader.epoch).toBe(epoch);
    fader.settle();
    expect(fader.epoch).not.toBe(epoch);
    const settled = fader.epoch;
    fader.settle();
    fader.set(gale, 14, 0);
    expect(fader.epoch).toBe(settled);
    fader.set(breeze, 14, 0);
    expect(fader.epoch).not.toBe(settled);
  });

  test('is another when the clock is sought to before an edit', () => {
    const fader = new WindFader(breeze);
    const { epoch } = fader;
    fader.set(gale, 10, 2);
    fader.at(30);
    fader.at(15);
    expect(fader.epoch).toBe(epoch);
    fader.at(5);
    expect(fader.epoch).not.toBe(epoch);
  });

  test('stays as it is when a gust is thrown that comes later, and nothing fades', () => {
    for (const seconds of [2, 0]) {
      const fader = new WindFader(breeze);
      const { epoch } = fader;
      fader.at(14, { x: 0, y: 0, yaw: 0 });
      fader.set(later, 14, seconds);
      expect(fader.fading(14)).toBe(false);
      expect(fader.target).toBe(later);
      expect(forceOf(fader, 25)).toEqual(steady(later, 25));
      expect(fader.epoch).toBe(epoch);
      // It has begun: taking it away again changes the past.
      fader.set(breeze, 25, seconds);
      expect(fader.fading(25)).toBe(seconds > 0);
      expect(fader.epoch === epoch).toBe(seconds > 0);
    }
  });

  test('a gust thrown amid a fade joins it', () => {
    const fader = new WindFader(gale);
    fader.set(breeze, 10, 2);
    fader.set(later, 11, 2);
    expect(fader.fading(12.5)).toBe(false);
    expect(forceOf(fader, 25)).toEqual(steady(later, 25));
  });

  test('a gust that is there already fades in', () => {
    const fader = new WindFader(breeze);
    fader.set(later, 20.5, 2);
    expect(fader.fading(21)).toBe(true);
  });

  test('winds are the same before a time where they differ in names, in what does not blow and in later gusts', () => {
    const same = (a: Wind, b: Wind) => sameBefore(a, b, 15, { x: 0, y: 0 });
    expect(same(breeze, { ...breeze, name: 'x', description: 'y', waves: breeze.waves.map((w) => ({ ...w })) })).toBe(
      true,
    );
    expect(
      same(breeze, { ...breeze, waves: [...breeze.waves, { ...twice(gale.waves[0] as Wind['waves'][0]), on: false }] }),
    ).toBe(true);
    expect(same(breeze, later)).toBe(true);
    expect(same(later, breeze)).toBe(true);
    expect(same(later, { ...breeze, gusts: [gust, ...later.gusts] })).toBe(false);
    expect(same({ ...breeze, gusts: [gust] }, { ...breeze, gusts: [gust, gust] })).toBe(false);
    for (const change of [
      { strength: 0.9 },
      { zeroMean: true },
      { stiffness: 2 },
      { model: 'sway' as const },
      { waves: breeze.waves.map(twice) },
      { spring: { ...breeze.spring, damping: 0.3 } },
      { profile: { ...breeze.profile, kind: 'log' as const } },
    ]) {
      expect(same(breeze, { ...breeze, ...change })).toBe(false);
    }
  });

  test('and where they are said to be, they give the same force to all of a tree', () => {
    const real = (min: number, max: number) => fc.double({ min, max, noNaN: true });
    const anyGust: fc.Arbitrary<Gust> = fc.record({
      start: real(0, 30),
      x: real(-100, 100),
      y: real(-100, 100),
      direction: real(0, 6.28),
      speed: real(4, 40),
      amplitude: real(0.05, 0.3),
      rise: real(0.1, 2),
      fall: real(0.5, 4),
      width: fc.constant(0),
      repeat: fc.constantFrom(0, 7),
    });
    let found = 0;
    fc.assert(
      fc.property(anyGust, real(-25, 25), real(-25, 25), fc.array(real(0, 1), { minLength: 20 }), (g, x, y, parts) => {
        const b = { ...breeze, gusts: [g] };
        if (!sameBefore(breeze, b, 15, place)) return;
        found++;
        for (const part of parts) {
          const states = [breeze, b].map((wind) => windStateAt(wind, 15 * part, place)) as [WindState, WindState];
          expect(windForce(states[1], x, y, 1)).toEqual(windForce(states[0], x, y, 1));
        }
      }),
      { numRuns: 300 },
    );
    expect(found).toBeGreaterThan(20);
  });
});
