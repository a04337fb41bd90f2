import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import { windForce } from '../../../src/core/wind/force.ts';
import { gustEnvelope, gustPush, gustRepeat, gustWidth, MAX_GUSTS } from '../../../src/core/wind/gust.ts';
import { type Gust, MOST_GUSTS, STILL, type Wind } from '../../../src/core/wind/wind.ts';
import { gust } from './any-winds.ts';

const blow = (gusts: Gust[], rest: Partial<Wind> = {}): Wind => ({ ...STILL, gusts, ...rest });
const forceAt = (wind: Wind, time: number, x = 0, y = 0): [number, number] =>
  windForce(windStateAt(wind, time), x, y, 0);

describe('gusts', () => {
  test('nothing before the front, the peak after the rise, nothing after the fall', () => {
    const wind = blow([gust]);
    expect(forceAt(wind, 9.99)).toEqual([0, 0]);
    expect(forceAt(wind, 10.5)[0]).toBeCloseTo(0.1, 6);
    expect(forceAt(wind, 11)[0]).toBeCloseTo(0.2, 6);
    expect(forceAt(wind, 12.5)[0]).toBeCloseTo(0.1, 6);
    expect(forceAt(wind, 14.01)).toEqual([0, 0]);
  });

  test('the front travels at its speed along its direction, and pushes along it', () => {
    const turned = { ...gust, direction: 0.7, x: 4, y: -2 };
    const [dx, dy] = [Math.cos(0.7), Math.sin(0.7)];
    for (const way of [-60, 0, 24]) {
      const [x, y] = forceAt(blow([turned]), 10.6 + way / 8, 4 + way * dx, -2 + way * dy);
      expect(x).toBeCloseTo(0.2 * gustEnvelope(0.6, 1, 3) * dx, 6);
      expect(y).toBeCloseTo(0.2 * gustEnvelope(0.6, 1, 3) * dy, 6);
    }
  });

  test('a narrow one has half its force at half its width, the same on either side, nothing far away', () => {
    const wind = blow([{ ...gust, width: 20, direction: Math.PI / 2 }]);
    const peak = forceAt(wind, 11)[1];
    expect(forceAt(wind, 11, 10)[1]).toBeCloseTo(peak / 2, 6);
    expect(forceAt(wind, 11, -10)[1]).toBeCloseTo(peak / 2, 6);
    expect(forceAt(wind, 11, 100)[1]).toBeLessThan(1e-8);
    expect(gustWidth(1e4, 0)).toBe(1);
  });

  test('rises and falls without a jump or a corner', () => {
    const dt = 1e-4;
    let [slope, bend] = [0, 0];
    for (let s = -1; s < 6; s += dt) {
      const [a, b, c] = [s, s + dt, s + 2 * dt].map((t) => gustEnvelope(t, 0.7, 2.1)) as [number, number, number];
      slope = Math.max(slope, Math.abs(b - a) / dt);
      bend = Math.max(bend, Math.abs(c - 2 * b + a) / dt ** 2);
    }
    // Those of a smooth step of 0.7 s: 1.5 and 6.
    expect(slope * 0.7).toBeLessThan(1.51);
    expect(bend * 0.7 ** 2).toBeLessThan(6.1);
    expect(gustEnvelope(0.7, 0.7, 2.1)).toBe(1);
  });

  test('only those that can be felt within 200 m take a slot', () => {
    const far = { ...gust, x: 5000 };
    const aside = { ...gust, width: 10, y: 600 };
    expect(windStateAt(blow([gust, far, aside]), 11).gustCount).toBe(1);
    expect(windStateAt(blow([gust, far, aside]), 11, { x: 5000, y: 600, yaw: 0 }).gustCount).toBe(1);
    expect(windStateAt(blow([gust]), 10 + 205 / 8 + 4).gustCount).toBe(0);
  });

  test('strength is a factor on them', () => {
    expect(forceAt(blow([gust], { strength: 0.5 }), 11)[0]).toBeCloseTo(0.1, 6);
    expect(windStateAt(blow([gust], { strength: 0 }), 11).gustCount).toBe(0);
  });

  test('of more than eight the loudest blow, and none comes or goes with a jump', () => {
    const real = (min: number, max: number) => fc.double({ min, max, noNaN: true });
    const any: fc.Arbitrary<Gust> = fc.record({
      start: real(0, 6),
      x: real(-10, 10),
      y: real(-10, 10),
      direction: real(0, 6.28),
      // Quick, so that their loudness, the most within 200 m, changes soon.
      speed: real(100, 400),
      amplitude: real(0.02, 0.2),
      rise: real(0.5, 2),
      fall: real(0.5, 2),
      width: fc.oneof(fc.constant(0), real(10, 60)),
      repeat: fc.constantFrom(0, 5),
    });
    const dt = 1 / 4000;
    // As quick as eight of them rise at most, each by five times where slots change hands.
    const most = dt * MAX_GUSTS * 0.2 * (1.5 / 0.5) * 5;
    fc.assert(
      fc.property(fc.array(any, { minLength: 14, maxLength: MOST_GUSTS }), (gusts) => {
        const wind = blow(gusts);
        let last = forceAt(wind, 0, 1, 2);
        let slots = 0;
        let jump = 0;
        for (let t = dt; t < 7; t += dt) {
          const state = windStateAt(wind, t);
          slots = Math.max(slots, state.gustCount);
          const force = windForce(state, 1, 2, 0);
          jump = Math.max(jump, Math.hypot(force[0] - last[0], force[1] - last[1]));
          last = force;
        }
        expect(slots).toBeLessThanOrEqual(MAX_GUSTS);
        expect(jump).toBeLessThan(most);
      }),
      { numRuns: 3, endOnFailure: true },
    );
  });

  test('twelve alike, thrown one after the other, still blow', () => {
    const alike = Array.from({ length: 12 }, (_, i) => ({ ...gust, rise: 3, fall: 3, start: 10 + 0.2 * i }));
    const force = forceAt(blow(alike), 14);
    expect(force[0]).toBeGreaterThan(2 * forceAt(blow([gust]), 11)[0]);
  });

  test('one that comes again is the same every time, and not there before the first', () => {
    const wind = blow([{ ...gust, repeat: 6 }]);
    const once = blow([gust]);
    for (const [x, y] of [
      [0, 0],
      [-35, 12],
      [35, -20],
    ] as const) {
      for (let t = 0; t < 40; t += 0.13) {
        const copies = Array.from({ length: 8 }, (_, n) => forceAt(once, t - 6 * n, x, y)[0]);
        const sum = copies.reduce((a, b) => a + b, 0);
        expect(forceAt(wind, t, x, y)[0]).toBeCloseTo(sum, 5);
        expect(forceAt(wind, t + 6e6, x, y)[0]).toBeCloseTo(forceAt(wind, t + 60, x, y)[0], 5);
      }
    }
    expect(windStateAt(wind, 6e6).gustCount).toBe(1);
  });

  test('never comes again before it is over, whatever the document says', () => {
    expect(gustRepeat({ repeat: 0, rise: 9, fall: 9 })).toBe(0);
    expect(gustRepeat({ repeat: 1, rise: 1, fall: 2 })).toBe(5);
    expect(gustRepeat({ repeat: 7, rise: 3, fall: 9 })).toBe(12);
    expect(gustRepeat({ repeat: 40, rise: 3, fall: 9 })).toBe(40);
  });

  test('a push is that of one gust alone', () => {
    const state = windStateAt(blow([gust, { ...gust, direction: 1 }]), 11.3);
    expect(gustPush(state, 0, 2, 5)).toBeCloseTo(forceAt(blow([gust]), 11.3, 2, 5)[0], 7);
  });
});
