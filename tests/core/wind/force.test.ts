import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createWindState, windStateAt } from '../../../src/core/wind/fade.ts';
import { linearWindForce, MAX_WAVES, meanPush, type Placement, windForce } from '../../../src/core/wind/force.ts';
import { forceDefines } from '../../../src/core/wind/force-variant.ts';
import { rebaseWave, rebaseWind } from '../../../src/core/wind/rebase.ts';
import { BEAUFORT, beaufortOf, forceOfSpeed, speedOfBeaufort, speedOfForce } from '../../../src/core/wind/speed.ts';
import { DEFAULT_WAVE, type Wave, type Wind } from '../../../src/core/wind/wind.ts';
import { anyWind, breeze, gale, gust } from './any-winds.ts';

const wave: Wave = { ...DEFAULT_WAVE, amplitude: 0.2, direction: 0.6, wavelength: 12, speed: 3, phase: 0.2 };
const wind: Wind = { ...breeze, waves: [wave] };
const speed = (f: [number, number]): number => Math.hypot(...f);
const forceAt = (of: Wind, time: number, x: number, y: number, z = 0, place?: Placement): [number, number] =>
  windForce(windStateAt(of, time, place), x, y, z);

describe('force', () => {
  test('crests travel along the direction of the wave, and push along it', () => {
    const [dx, dy] = [Math.cos(wave.direction), Math.sin(wave.direction)];
    for (const t of [0, 1.3, 7]) {
      const [a, b] = [forceAt(wind, 0, 1, 2), forceAt(wind, t, 1 + 3 * t * dx, 2 + 3 * t * dy)];
      expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeLessThan(1e-6);
    }
    for (let t = 0; t < 4; t += 0.1) {
      const f = forceAt(wind, t, 3, -1);
      expect(f[0] * dx + f[1] * dy).toBeGreaterThanOrEqual(0);
      expect(Math.abs(f[0] * dy - f[1] * dx)).toBeLessThan(1e-8);
    }
  });

  test('in the paper they travel against it', () => {
    const paper = { ...wind, paper: true };
    const [dx, dy] = [Math.cos(wave.direction), Math.sin(wave.direction)];
    const [a, b] = [forceAt(paper, 0, 1, 2), forceAt(paper, 1.3, 1 - 3.9 * dx, 2 - 3.9 * dy)];
    expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeLessThan(1e-6);
  });

  test('reaches the amplitude and falls to nothing', () => {
    const forces = Array.from({ length: 400 }, (_, i) => speed(forceAt(wind, i / 100, 0, 0)));
    expect(Math.max(...forces)).toBeCloseTo(0.2, 4);
    expect(Math.min(...forces)).toBeCloseTo(0, 4);
  });

  test('has the mean that its sharpness gives it, or none where it is to have none', () => {
    const n = 400;
    const [dx, dy] = [Math.cos(wave.direction), Math.sin(wave.direction)];
    for (const zeroMean of [false, true]) {
      let sum = 0;
      for (let i = 0; i < n; i++) {
        const [x, y] = forceAt({ ...wind, zeroMean }, (4 * i) / n, 0, 0);
        sum += x * dx + y * dy;
      }
      expect(sum / n).toBeCloseTo(zeroMean ? 0 : 0.2 * meanPush(2), 6);
    }
  });

  test('is the same after a year as its phase says', () => {
    const year = 4 * 7_884_000; // whole periods of 4 s
    const [a, b] = [forceAt(wind, 1.5, 1, 1), forceAt(wind, 1.5 + year, 1, 1)];
    expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeLessThan(1e-6);
  });

  test('a tree that stands elsewhere and is turned feels the same wind there', () => {
    const place = { x: 40, y: -17, yaw: 0.8 };
    const [cos, sin] = [Math.cos(place.yaw), Math.sin(place.yaw)];
    fc.assert(
      fc.property(
        anyWind,
        fc.double({ min: 90, max: 120, noNaN: true }),
        fc.double({ min: -8, max: 8, noNaN: true }),
        fc.double({ min: -8, max: 8, noNaN: true }),
        (any, time, x, y) => {
          const [fx, fy] = forceAt(any, time, x, y, 4, place);
          const world = forceAt(any, time, place.x + cos * x - sin * y, place.y + sin * x + cos * y, 4);
          expect(fx * cos - fy * sin).toBeCloseTo(world[0], 4);
          expect(fx * sin + fy * cos).toBeCloseTo(world[1], 4);
        },
      ),
      { numRuns: 300 },
    );
  });

  test('waves that are off, without amplitude or beyond sixteen are left out', () => {
    const waves = [{ ...wave, on: false }, { ...wave, amplitude: 0 }, wave];
    expect(windStateAt({ ...wind, waves }, 0).count).toBe(1);
    expect(windStateAt({ ...wind, strength: 0 }, 0).count).toBe(0);
    expect(windStateAt({ ...wind, waves: Array(20).fill(wave) }, 0).count).toBe(MAX_WAVES);
  });

  test('a wave that is solo blows alone', () => {
    const solo = { ...gale, waves: gale.waves.map((w, i) => ({ ...w, solo: i === 2 })) };
    expect(forceAt(solo, 3, 1, 2)).toEqual(forceAt({ ...gale, waves: [gale.waves[2] as Wave] }, 3, 1, 2));
    const off = { ...gale, waves: gale.waves.map((w, i) => ({ ...w, solo: i === 2, on: i !== 2 })) };
    expect(windStateAt(off, 3).count).toBe(3);
  });

  test('the parts add up, by the factor of the height', () => {
    const record = { name: 'r', step: 1, speed: [2, 4, 8, 3], direction: [0, 1, 2, 1] };
    const profile = { kind: 'power', height: 10, roughness: 0.1, exponent: 0.5 } as const;
    const all = { ...gale, gusts: [gust], record, profile };
    const parts = [gale, { ...gale, waves: [], gusts: [gust] }, { ...gale, waves: [], record }];
    const sum = parts.map((part) => forceAt(part, 11.2, 1, 2)).reduce((a, b) => [a[0] + b[0], a[1] + b[1]]);
    const [x, y] = forceAt(all, 11.2, 1, 2, 2.5);
    expect(x).toBeCloseTo(sum[0] / 2, 6);
    expect(y).toBeCloseTo(sum[1] / 2, 6);
    expect(forceDefines(windStateAt(all, 11.2))).toEqual({
      WIND_WAVES: 4,
      WIND_GUSTS: 8,
      WIND_PROFILE: 1,
      WIND_RECORD: 1,
    });
  });

  test('a wind of four waves and nothing else asks for no more than that', () => {
    expect(forceDefines(windStateAt(gale, 5))).toEqual({
      WIND_WAVES: 4,
      WIND_GUSTS: 0,
      WIND_PROFILE: 0,
      WIND_RECORD: 0,
    });
  });

  test('slots of an earlier wind that are not in use push nothing: the shader sums them all', () => {
    const state = windStateAt({ ...gale, gusts: [gust, gust] }, 11, undefined, createWindState());
    windStateAt({ ...gale, waves: [wave] }, 11, undefined, state);
    expect([state.count, state.gustCount]).toEqual([1, 0]);
    expect(state.waves.subarray(4).every((n) => n === 0)).toBe(true);
    expect(Array.from({ length: 8 }, (_, i) => state.gusts[12 * i + 2])).toEqual(Array(8).fill(0));
  });

  test('without peaks pulls as much as it pushes', () => {
    let sum = 0;
    for (let i = 0; i < 400; i++) sum += linearWindForce(windStateAt(wind, i / 100), 0, 0)[0];
    expect(sum / 400).toBeCloseTo(0, 6);
  });
});

describe('speed', () => {
  test('and force are one another’s inverse', () => {
    expect(speedOfForce(forceOfSpeed(7.3))).toBeCloseTo(7.3, 12);
  });

  test('every force of the Beaufort scale begins where the last one ends, and its law lies within it', () => {
    expect(BEAUFORT.map(({ number }) => number)).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
    for (const force of BEAUFORT) {
      expect(force.from).toBe(BEAUFORT[force.number - 1]?.to ?? 0);
      expect(beaufortOf(force.from)).toBe(force);
      expect(beaufortOf(speedOfBeaufort(force.number))).toBe(force);
    }
    expect(beaufortOf(100).name).toBe('Hurricane');
    expect(beaufortOf(-1).number).toBe(0);
  });
});

describe('rebasing', () => {
  test('a wave that changes speed or wavelength keeps its phase at that time', () => {
    for (const change of [{ speed: 7 }, { wavelength: 5 }, { speed: 0, wavelength: 30 }]) {
      const next = rebaseWave(wave, change, 600.3);
      const a = windStateAt(wind, 600.3).phases[1] as number;
      const b = windStateAt({ ...wind, waves: [next] }, 600.3).phases[1] as number;
      expect(Math.abs(a - b - Math.round(a - b))).toBeLessThan(1e-6);
      expect(next).toMatchObject(change);
    }
  });

  test('a document is rebased where its edit changes a speed, and only there', () => {
    const next: Wind = {
      ...gale,
      waves: gale.waves.map((w, i) => (i === 2 ? { ...w, speed: 9 } : { ...w, amplitude: 1 })),
    };
    const rebased = rebaseWind(gale, next, 33);
    expect(rebased.waves.map((w, i) => w.phase === gale.waves[i]?.phase)).toEqual([true, true, false, true]);
    expect(windStateAt(rebased, 33).phases[9]).toBeCloseTo(windStateAt(gale, 33).phases[9] as number, 6);
  });

  test('a phase that the edit sets is left as it is', () => {
    const next: Wind = { ...gale, waves: gale.waves.map((w) => ({ ...w, speed: 9, phase: 0.123 })) };
    expect(rebaseWind(gale, next, 33).waves.map((w) => w.phase)).toEqual([0.123, 0.123, 0.123, 0.123]);
  });

  test('waves that come, go or change places are not taken for others', () => {
    const [a, b] = [
      { ...wave, phase: 0 },
      { ...wave, phase: 0, speed: 8 },
    ];
    const both = { ...gale, waves: [a, b] };
    for (const waves of [[b, a], [b], [{ ...DEFAULT_WAVE }, a, b]]) {
      expect(rebaseWind(both, { ...gale, waves }, 33).waves).toEqual(waves);
    }
  });
});
