import { describe, expect, test } from 'vitest';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import { windForce } from '../../../src/core/wind/force.ts';
import { loopPeriod, loopWind, SWAY_SECONDS } from '../../../src/core/wind/loop.ts';
import { DEFAULT_WAVE, type Wave, type Wind, type WindRecord } from '../../../src/core/wind/wind.ts';
import { breeze, gale, gust } from './any-winds.ts';

/** A wave that comes around in so many seconds. */
const period = (seconds: number, rest: Partial<Wave> = {}): Wave => ({
  ...DEFAULT_WAVE,
  wavelength: 12,
  speed: 12 / seconds,
  phase: 0.3,
  ...rest,
});
const waves = (...all: Wave[]): Wind => ({ ...breeze, waves: all });
const record: WindRecord = {
  name: 'r',
  step: 0.5,
  speed: Array.from({ length: 25 }, (_, i) => 5 + Math.sin(i)),
  direction: Array.from({ length: 25 }, (_, i) => 0.2 * Math.sin(2 * i)),
};
const forceAt = (wind: Wind, time: number, x = 3, y = -2) => windForce(windStateAt(wind, time), x, y, 2);

/** The largest difference of the force between a loop and its next round, all over a tree. */
function seam(wind: Wind, seconds: number, time: number): number {
  let worst = 0;
  for (let i = 0; i <= 200; i++) {
    for (const [x, y] of [
      [0, 0],
      [12, -9],
      [-20, 15],
    ]) {
      const t = time + (i / 200) * seconds;
      // Within the loop itself only its ends are compared: a copy of a gust for every round is not asked for.
      if (i !== 0 && wind.gusts.length > 0) continue;
      const [a, b] = [forceAt(wind, t, x, y), forceAt(wind, t + seconds, x, y)];
      worst = Math.max(worst, Math.hypot(a[0] - b[0], a[1] - b[1]));
    }
  }
  return worst;
}

describe('the common period', () => {
  test('is the shortest time in which all that blow make whole turns', () => {
    expect(loopPeriod(waves(period(4)))).toBeCloseTo(4, 9);
    expect(loopPeriod(waves(period(4), period(6), period(3)))).toBeCloseTo(12, 9);
    expect(loopPeriod(waves(period(5), period(7)))).toBeCloseTo(35, 9);
  });

  test('hears only what blows and moves', () => {
    const mute = [period(7, { on: false }), period(7, { amplitude: 0 }), period(7, { speed: 0 })];
    expect(loopPeriod(waves(period(4), ...mute))).toBeCloseTo(4, 9);
    expect(loopPeriod(waves(period(4, { solo: true }), period(6)))).toBeCloseTo(4, 9);
    expect(loopPeriod(waves(...mute))).toBe(0);
    expect(loopPeriod({ ...gale, strength: 0 })).toBe(0);
  });

  test('lets a wave be a little off, but no more', () => {
    expect(loopPeriod(waves(period(4), period(6.002)), 600, 0.005)).toBeCloseTo(12, 2);
    expect(loopPeriod(waves(period(4), period(6.3)), 60, 0.001)).toBeNull();
    expect(loopPeriod(waves(period(5), period(7)), 30)).toBeNull();
  });

  test('takes in gusts that come again', () => {
    const wind = { ...waves(period(4)), gusts: [{ ...gust, repeat: 10 }, gust] };
    expect(loopPeriod(wind)).toBeCloseTo(20, 9);
  });

  test('takes the record in, and knows that sway has its own', () => {
    expect(loopPeriod({ ...waves(period(5)), record })).toBeCloseTo(25, 9);
    expect(loopPeriod({ ...waves(period(4)), model: 'sway' })).toBeNull();
    expect(loopPeriod({ ...waves(period(4)), model: 'sway' }, 5000)).toBe(SWAY_SECONDS);
  });
});

describe('a wind that loops', () => {
  test('comes around, with each crest at the start where it was', () => {
    for (const [seconds, time] of [
      [10, 0],
      [8, 123.4],
      [31.7, 1e5],
    ] as const) {
      const { wind, change, open } = loopWind(gale, seconds, time);
      expect(open).toEqual([]);
      const [a, b] = [forceAt(wind, time), forceAt(gale, time)];
      expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeLessThan(1e-5);
      expect(seam(wind, seconds, time)).toBeLessThan(1e-5);
      const real = wind.waves.map((wave, i) => Math.abs(wave.speed / (gale.waves[i] as Wave).speed - 1));
      expect(change).toBeCloseTo(Math.max(...real), 12);
    }
    expect(loopPeriod(loopWind(gale, 10, 3).wind)).toBeCloseTo(10, 6);
  });

  test('lasts more than no time', () => {
    for (const seconds of [0, -1, Number.NaN]) expect(() => loopWind(gale, seconds, 0)).toThrow(RangeError);
  });

  test('changes nothing that fits already', () => {
    expect(loopWind(waves(period(4), period(6)), 12, 50).change).toBeLessThan(1e-12);
  });

  test('waves that stand still or do not blow are left as they are; a slow one turns once', () => {
    const wind = waves(period(7, { on: false }), period(7, { speed: 0 }), period(300));
    const looped = loopWind(wind, 10, 0);
    expect(looped.wind.waves.slice(0, 2)).toEqual(wind.waves.slice(0, 2));
    expect(looped.wind.waves[2]?.speed).toBeCloseTo(1.2, 12);
    expect(looped.change).toBeCloseTo(29, 9);
  });

  test('a gust that reaches over the end of the loop comes in at its start', () => {
    const wind = {
      ...gale,
      gusts: [
        { ...gust, start: 109, speed: 6 },
        { ...gust, start: 500 },
      ],
    };
    const looped = loopWind(wind, 12, 100);
    expect(looped.open).toEqual([]);
    expect(seam(looped.wind, 12, 100)).toBeLessThan(1e-5);
    expect(forceAt(looped.wind, 100)[0] - forceAt(gale, 100)[0]).toBeGreaterThan(1e-3);
    expect(looped.wind.gusts.some(({ start }) => start > 400)).toBe(false);
  });

  test('a gust within the loop has come a round before too, for a tree that still swings by it', () => {
    const wind = { ...gale, gusts: [{ ...gust, start: 105, speed: 40 }] };
    const looped = loopWind(wind, 12, 100);
    expect(forceAt(looped.wind, 94)[0]).toBeCloseTo(forceAt(looped.wind, 106)[0], 5);
    expect(forceAt(looped.wind, 106)[0]).toBeGreaterThan(0.1);
    expect(looped.wind.gusts.length).toBe(2);
  });

  test('gusts that come again do so a whole number of times, being at the start where they were', () => {
    const wind = { ...gale, gusts: [{ ...gust, repeat: 7.3 }] };
    for (const time of [3, 60, 1e4]) {
      const { wind: looped, change, open } = loopWind(wind, 23, time);
      expect(open).toEqual([]);
      expect(looped.gusts.length).toBe(1);
      expect(looped.gusts[0]!.repeat).toBeCloseTo(23 / 3, 9);
      expect(change).toBeGreaterThan(0.04);
      expect(seam(looped, 23, time)).toBeLessThan(1e-5);
      expect(forceAt(looped, time + 30)[0]).toBeCloseTo(forceAt(looped, time + 7)[0], 5);
      if (time > 30) expect(forceAt(looped, time)[0]).toBeCloseTo(forceAt(wind, time)[0], 5);
    }
    // Two of them would come before the first is over.
    const long = { ...gale, gusts: [{ ...gust, fall: 10, repeat: 11 }] };
    expect(loopWind(long, 20, 60).wind.gusts[0]!.repeat).toBeCloseTo(20, 9);
  });

  test('of gusts that come again after more than a loop those within it are in it', () => {
    const wind = { ...gale, gusts: [{ ...gust, start: 4, repeat: 100, speed: 40 }] };
    const looped = loopWind(wind, 12, 300);
    expect(looped.open).toEqual([]);
    expect(looped.wind.gusts.every(({ repeat }) => repeat === 0)).toBe(true);
    expect(forceAt(looped.wind, 305)[0] - forceAt({ ...looped.wind, gusts: [] }, 305)[0]).toBeGreaterThan(0.1);
    expect(loopWind(wind, 12, 330).wind.gusts).toEqual([]);
  });

  test('a loop that is short for its gusts says so', () => {
    const wind = { ...gale, gusts: Array.from({ length: 6 }, (_, i) => ({ ...gust, start: 100 + i, fall: 12 })) };
    const { open, wind: looped } = loopWind(wind, 5, 100);
    expect(open).toEqual(['gusts']);
    expect(looped.gusts.length).toBe(16);
  });

  test('a record plays in whole rounds; one that is longer than the loop stays open', () => {
    const wind = { ...gale, record };
    const { wind: looped, change, open } = loopWind(wind, 26, 40);
    expect(open).toEqual([]);
    expect(seam(looped, 26, 40)).toBeLessThan(1e-5);
    expect(change).toBeGreaterThanOrEqual(0.04 - 1e-9);
    expect(loopWind(wind, 6, 40).open).toEqual(['record']);
  });

  test('sway does not come around sooner than its frequencies do', () => {
    const wind: Wind = { ...gale, model: 'sway' };
    expect(loopWind(wind, 20, 0).open).toEqual(['sway']);
    expect(loopWind(wind, SWAY_SECONDS, 0).open).toEqual([]);
  });
});
