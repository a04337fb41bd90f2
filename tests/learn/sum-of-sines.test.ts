import { describe, expect, test } from 'vitest';
import { meanPush } from '../../src/core/wind/force.ts';
import { gustArrival } from '../../src/core/wind/gust.ts';
import { dominantFrequency, spectrumOf } from '../../src/core/wind/spectrum.ts';
import { DEFAULT_GUST } from '../../src/core/wind/wind.ts';
import { alongX, crestSpeed } from '../../src/learn/sum-of-sines/crest.ts';
import { firstFelt } from '../../src/learn/sum-of-sines/gust.ts';
import { meanForce, measuredMean } from '../../src/learn/sum-of-sines/lean.ts';
import { periodOf, printedPush, sharpPush } from '../../src/learn/sum-of-sines/sharp-push.ts';
import { AskedWind, someWaves, windOf } from '../../src/learn/sum-of-sines/waves.ts';

describe('lesson: sum of sines', () => {
  test('a printed crest runs upwind, ours with the wind, at the speed that is set', () => {
    for (const time of [0, 0.7, 3.1]) {
      expect(crestSpeed(alongX(15, 3, true), 15, time)).toBeCloseTo(-3, 2);
      expect(crestSpeed(alongX(15, 3, false), 15, time)).toBeCloseTo(3, 2);
    }
  });

  test('(sin/2)^k is a quarter at crest and trough for k = 2 and has no value half of the time for k = 2.5', () => {
    expect(printedPush(2, false)(0.25)).toBeCloseTo(0.25, 12);
    expect(printedPush(2, false)(0.75)).toBeCloseTo(0.25, 12);
    expect(periodOf(printedPush(2.5, false)).valued).toBe(0.5);
    expect(sharpPush(2, false)(0.25)).toBeCloseTo(1, 9);
    expect(sharpPush(2, false)(0.75)).toBeCloseTo(0, 9);
    for (const k of [0.5, 1, 2.5, 4]) {
      const { valued, most } = periodOf(sharpPush(k, false));
      expect([valued, most > 0.999]).toEqual([1, true]);
      expect(sharpPush(k, false)(1)).toBeCloseTo(2 ** -k, 9);
    }
  });

  test('the mean push is what the formula says, to the digits of the table, and 0 where it is taken off', () => {
    for (const [k, said] of [
      [1.5, '0.424413'],
      [2, '0.375000'],
      [4, '0.273438'],
    ] as const) {
      expect(periodOf(sharpPush(k, false)).mean.toFixed(6)).toBe(said);
      expect(meanPush(k).toFixed(6)).toBe(said);
      expect(periodOf(sharpPush(k, true)).mean).toBeCloseTo(0, 6);
    }
  });

  test('the tree leans where the sum of D A m(k) is', () => {
    const wind = windOf(someWaves(4, 2.2, 0.4, 1.6));
    const [x, y] = meanForce(wind);
    const [mx, my] = measuredMean(wind);
    expect(Math.hypot(mx - x, my - y)).toBeLessThan(1e-3);
    expect(Math.hypot(x, y)).toBeGreaterThan(0.05);
    expect(Math.hypot(...measuredMean({ ...wind, zeroMean: true }))).toBeLessThan(1e-3);
  });

  test('the strongest line of the spectrum is c/lambda of the strongest wave', () => {
    const [wave] = someWaves(1, 2.2, 0, 0);
    const asked = new AskedWind(windOf(wave ? [wave] : []));
    const signal = Float64Array.from({ length: 12 * 1400 }, (_, i) => asked.at(0, 0, i / 12)[0]);
    expect(dominantFrequency(spectrumOf(signal, 12, 4096))).toBeCloseTo(4.6 / 34, 3);
  });

  test('a gust is felt when its front arrives', () => {
    const gust = { ...DEFAULT_GUST, start: 0.5, x: -24, y: 0, direction: 0.15, width: 30 };
    const felt = firstFelt(windOf([], { gusts: [gust] }), [14, 3], 14);
    expect(felt).toBeCloseTo(gustArrival(gust, 14, 3), 2);
  });
});
