import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { PROBE_RATE, ProbeHistory } from '../../../src/core/wind/probe-history.ts';
import { rootMeanSquare, summarize } from '../../../src/core/wind/probe-summary.ts';
import { speedOfForce } from '../../../src/core/wind/speed.ts';

const reading = (k: number) => ({ fx: k, fy: 2 * k, x: 0.1 * k, y: -0.2 * k, z: 0.01 * k });

/** A swing of 2 Hz and 3 cm along x, in a force of 0.5 Hz. */
function swing(steps: number): ProbeHistory {
  const history = new ProbeHistory();
  for (let n = 0; n < steps; n++) {
    const t = n / PROBE_RATE;
    const x = 0.01 + 0.03 * Math.sin(2 * Math.PI * 2 * t);
    history.push(n, { fx: 0.05 * (1 + Math.sin(2 * Math.PI * 0.5 * t)), fy: 0, x, y: 0, z: 0 });
  }
  return history;
}

describe('a history', () => {
  test('keeps the newest readings, however many there were', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 2, max: 40 }),
        fc.integer({ min: 0, max: 500 }),
        fc.nat(300),
        (size, from, more) => {
          const history = new ProbeHistory(size);
          for (let n = from; n <= from + more; n++) history.push(n, reading(n));
          const count = Math.min(size, more + 1);
          expect([history.count, history.first, history.last]).toEqual([count, from + more - count + 1, from + more]);
          expect(history.reading(history.first)).toEqual(reading(history.first));
          expect(history.reading(history.last)).toEqual(reading(history.last));
          expect([history.reading(history.first - 1), history.reading(history.last + 1)]).toEqual([null, null]);
          expect([...history.column('time', 0)][0]).toBe(history.first / PROBE_RATE);
        },
      ),
    );
  });

  test('starts anew after a gap, and is cut where time went back', () => {
    const history = new ProbeHistory(10);
    for (const n of [3, 4, 5]) history.push(n, reading(n));
    history.cut(4);
    expect([history.first, history.last, history.count]).toEqual([3, 4, 2]);
    history.push(5, reading(50));
    expect(history.reading(5)?.fx).toBe(50);
    history.push(9, reading(9));
    expect([history.first, history.last]).toEqual([9, 9]);
    history.cut(2);
    expect([history.count, history.last]).toEqual([0, -1]);
    expect(history.column('along', 0)).toHaveLength(0);
  });

  test('turns its columns into the direction that is asked for', () => {
    const history = new ProbeHistory(4);
    history.push(0, { fx: 3, fy: 4, x: 1, y: 1, z: 7 });
    const axis = Math.atan2(4, 3);
    const at = (name: Parameters<ProbeHistory['column']>[0]): number => history.column(name, axis)[0];
    expect(at('force')).toBeCloseTo(5, 12);
    expect(at('forceAlong')).toBeCloseTo(5, 12);
    expect(at('forceAcross')).toBeCloseTo(0, 12);
    expect(at('along')).toBeCloseTo(1.4, 12);
    expect(at('across')).toBeCloseTo(-0.2, 12);
    expect(at('up')).toBe(7);
    expect(at('velocityAlong')).toBe(0);
  });

  test('gives the velocity of a swing', () => {
    const velocity = swing(240).column('velocityAlong', 0);
    const most = 0.03 * 2 * Math.PI * 2;
    for (const n of [30, 100, 200]) {
      expect(velocity[n]).toBeCloseTo(most * Math.cos((2 * Math.PI * 2 * n) / PROBE_RATE), 2);
    }
  });
});

describe('its summary', () => {
  test('has means, greatest values and dominant frequencies', () => {
    const summary = summarize(swing(3600), 0)!;
    expect(summary.seconds).toBe(60);
    // The mean of the speeds is not the speed of the mean force.
    expect(summary.wind.mean).toBeLessThan(speedOfForce(0.05));
    expect(summary.wind.mean).toBeGreaterThan(0.8 * speedOfForce(0.05));
    expect(summary.wind.greatest).toBeCloseTo(speedOfForce(0.1), 4);
    expect(summary.displacement.mean).toBeCloseTo(0.01, 4);
    expect(summary.displacement.greatest).toBeCloseTo(0.04, 3);
    expect(summary.velocity.rms).toBeCloseTo((0.03 * 2 * Math.PI * 2) / Math.SQRT2, 2);
    expect(summary.frequency.wind).toBeCloseTo(0.5, 1);
    expect(summary.frequency.displacement).toBeCloseTo(2, 1);
  });

  test('says nothing of next to nothing', () => {
    expect(summarize(swing(15), 0)).toBeNull();
    expect(rootMeanSquare(new Float64Array(0))).toBe(0);
  });
});
