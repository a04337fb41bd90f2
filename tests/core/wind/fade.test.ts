import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { WindFader } from '../../../src/core/wind/fade.ts';
import { wavesAt, windForce } from '../../../src/core/wind/force.ts';
import { presets } from '../../../src/core/wind/presets.ts';
import type { Wind } from '../../../src/core/wind/wind.ts';

const { breeze, gale, still } = presets;
const place = { x: 12, y: 30, yaw: 1 };
const forceOf = (fader: WindFader, time: number): [number, number] => windForce(fader.at(time, place), 1, 2);
const steady = (wind: Wind, time: number): [number, number] => windForce(wavesAt(wind, time, place), 1, 2);
const apart = (a: [number, number], b: [number, number]): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** A wind of any parameters. */
const anyWind: fc.Arbitrary<Wind> = fc
  .array(
    fc.record({
      on: fc.boolean(),
      amplitude: fc.double({ min: 0, max: 0.3, noNaN: true }),
      direction: fc.double({ min: 0, max: 6.28, noNaN: true }),
      wavelength: fc.double({ min: 6, max: 60, noNaN: true }),
      speed: fc.double({ min: 0, max: 15, noNaN: true }),
      sharpness: fc.double({ min: 1, max: 4, noNaN: true }),
      phase: fc.double({ min: 0, max: 1, noNaN: true }),
    }),
    { minLength: 4, maxLength: 4 },
  )
  .chain((waves) => fc.double({ min: 0, max: 1, noNaN: true }).map((strength) => ({ ...breeze, strength, waves })));

describe('fading', () => {
  test('no edit makes the force jump', () => {
    const dt = 1 / 1000;
    // Most that four waves of 0.3 m change in dt: 2.5 turns a second times a slope of at most pi sqrt(k); and two winds of them that
    // cross-fade within half a second or more.
    const most = dt * (2 * 4 * 0.3 * 2.5 * Math.PI * 2 + (1.5 / 0.5) * 8 * 0.3);
    fc.assert(
      fc.property(
        fc.array(fc.tuple(anyWind, fc.double({ min: 0.02, max: 1.5, noNaN: true })), { minLength: 1, maxLength: 5 }),
        (edits) => {
          const fader = new WindFader(breeze);
          let time = 100;
          let next = 0;
          let wait = 0.1;
          let last = forceOf(fader, time);
          for (let i = 0; i < 3000; i++) {
            time += dt;
            wait -= dt;
            if (wait <= 0 && next < edits.length) {
              const before = forceOf(fader, time);
              fader.set(edits[next][0], time, 0.5);
              expect(apart(forceOf(fader, time), before)).toBeLessThan(1e-7);
              wait = edits[next++][1];
            }
            const force = forceOf(fader, time);
            expect(apart(force, last)).toBeLessThan(most);
            last = force;
          }
        },
      ),
      { numRuns: 15 },
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
    fader.set(presets['light-air'], 11, 2);
    expect(fader.target.name).toBe('light-air');
    const other = new WindFader(breeze);
    other.set(gale, 10, 2);
    expect(apart(forceOf(fader, 11.9), forceOf(other, 11.9))).toBeLessThan(1e-7);
    expect(apart(forceOf(fader, 14), steady(presets['light-air'], 14))).toBeLessThan(1e-7);
  });

  test('one fade passes into the next without a step', () => {
    const fader = new WindFader({ ...still, strength: 1, waves: gale.waves });
    fader.set(breeze, 10, 1);
    fader.set({ ...gale, waves: gale.waves.map((w) => ({ ...w, amplitude: 2, direction: 3 })) }, 10.2, 2);
    for (const seam of [10, 11, 13]) {
      expect(apart(forceOf(fader, seam - 1e-6), forceOf(fader, seam + 1e-6))).toBeLessThan(1e-4);
    }
  });

  test('fades to nothing and back again', () => {
    const fader = new WindFader(breeze);
    fader.set({ ...breeze, strength: 0 }, 0, 1);
    expect(fader.at(0.5).count).toBe(4);
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

  test('waves that differ in strength alone take one slot, others two', () => {
    const fader = new WindFader(breeze);
    const louder = { ...breeze, waves: breeze.waves.map((w) => ({ ...w, amplitude: 2 * w.amplitude })) };
    fader.set(louder, 0, 1);
    const half = fader.at(0.5);
    expect(half.count).toBe(4);
    expect(half.waves[2]).toBeCloseTo(1.5 * breeze.waves[0].amplitude, 6);
    fader.set(gale, 2, 1);
    expect(fader.at(2.5).count).toBe(8);
  });

  test('exponents fade too', () => {
    const fader = new WindFader(breeze);
    fader.set({ ...breeze, forceExponent: 1.8, lengthExponent: 2 }, 0, 1);
    const half = fader.at(0.5);
    expect([half.forceExponent, half.lengthExponent]).toEqual([1.4, expect.closeTo(1.3, 12)]);
  });
});
