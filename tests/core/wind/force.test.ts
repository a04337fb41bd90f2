import { describe, expect, test } from 'vitest';
import { linearWindForce, MAX_WAVES, meanPush, wavesAt, windForce } from '../../../src/core/wind/force.ts';
import { presets } from '../../../src/core/wind/presets.ts';
import { rebaseWave, rebaseWind } from '../../../src/core/wind/rebase.ts';
import type { Wave, Wind } from '../../../src/core/wind/wind.ts';

const wave: Wave = { on: true, amplitude: 0.2, direction: 0.6, wavelength: 12, speed: 3, sharpness: 2, phase: 0.2 };
const wind: Wind = { ...presets.breeze, strength: 1, waves: [wave] };
const speed = (f: [number, number]): number => Math.hypot(...f);

describe('force', () => {
  test('crests travel along the direction of the wave, and push along it', () => {
    const [dx, dy] = [Math.cos(wave.direction), Math.sin(wave.direction)];
    for (const t of [0, 1.3, 7]) {
      const [a, b] = [windForce(wavesAt(wind, 0), 1, 2), windForce(wavesAt(wind, t), 1 + 3 * t * dx, 2 + 3 * t * dy)];
      expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeLessThan(1e-6);
    }
    for (let t = 0; t < 4; t += 0.1) {
      const f = windForce(wavesAt(wind, t), 3, -1);
      expect(f[0] * dx + f[1] * dy).toBeGreaterThanOrEqual(0);
      expect(Math.abs(f[0] * dy - f[1] * dx)).toBeLessThan(1e-8);
    }
  });

  test('in the paper they travel against it', () => {
    const paper = { ...wind, paper: true };
    const [dx, dy] = [Math.cos(wave.direction), Math.sin(wave.direction)];
    const [a, b] = [windForce(wavesAt(paper, 0), 1, 2), windForce(wavesAt(paper, 1.3), 1 - 3.9 * dx, 2 - 3.9 * dy)];
    expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeLessThan(1e-6);
  });

  test('reaches the amplitude and falls to nothing', () => {
    const forces = Array.from({ length: 400 }, (_, i) => speed(windForce(wavesAt(wind, i / 100), 0, 0)));
    expect(Math.max(...forces)).toBeCloseTo(0.2, 4);
    expect(Math.min(...forces)).toBeCloseTo(0, 4);
  });

  test('has the mean that its sharpness gives it', () => {
    const n = 400;
    let sum = 0;
    for (let i = 0; i < n; i++) sum += speed(windForce(wavesAt(wind, (4 * i) / n), 0, 0));
    expect(sum / n).toBeCloseTo(0.2 * meanPush(2), 6);
  });

  test('is the same after a year as its phase says', () => {
    const year = 4 * 7_884_000; // whole periods of 4 s
    const [a, b] = [windForce(wavesAt(wind, 1.5), 1, 1), windForce(wavesAt(wind, 1.5 + year), 1, 1)];
    expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeLessThan(1e-6);
  });

  test('a tree that stands elsewhere and is turned feels the same wind there', () => {
    const place = { x: 40, y: -17, yaw: 0.8 };
    const [cos, sin] = [Math.cos(place.yaw), Math.sin(place.yaw)];
    for (const [x, y] of [
      [0, 0],
      [1, 3],
      [-2, 0.5],
    ]) {
      const there = windForce(wavesAt(presets.gale, 12.3, place), x, y);
      const world = windForce(wavesAt(presets.gale, 12.3), place.x + cos * x - sin * y, place.y + sin * x + cos * y);
      expect(there[0] * cos - there[1] * sin).toBeCloseTo(world[0], 5);
      expect(there[0] * sin + there[1] * cos).toBeCloseTo(world[1], 5);
    }
  });

  test('waves that are off, without amplitude or beyond eight are left out', () => {
    const waves = [{ ...wave, on: false }, { ...wave, amplitude: 0 }, wave];
    expect(wavesAt({ ...wind, waves }, 0).count).toBe(1);
    expect(wavesAt({ ...wind, strength: 0 }, 0).count).toBe(0);
    expect(wavesAt({ ...wind, waves: Array(11).fill(wave) }, 0).count).toBe(MAX_WAVES);
  });

  test('without peaks pulls as much as it pushes', () => {
    let sum = 0;
    for (let i = 0; i < 400; i++) sum += linearWindForce(wavesAt(wind, i / 100), 0, 0)[0];
    expect(sum / 400).toBeCloseTo(0, 6);
  });
});

describe('rebasing', () => {
  test('a wave that changes speed or wavelength keeps its phase at that time', () => {
    for (const change of [{ speed: 7 }, { wavelength: 5 }, { speed: 0, wavelength: 30 }]) {
      const next = rebaseWave(wave, change, 600.3);
      const a = wavesAt(wind, 600.3).phases[1];
      const b = wavesAt({ ...wind, waves: [next] }, 600.3).phases[1];
      expect(Math.abs(a - b - Math.round(a - b))).toBeLessThan(1e-6);
      expect(next).toMatchObject(change);
    }
  });

  test('a document is rebased where its edit changes a speed, and only there', () => {
    const old = presets.breeze;
    const next: Wind = {
      ...old,
      waves: old.waves.map((w, i) => (i === 2 ? { ...w, speed: 9 } : { ...w, amplitude: 1 })),
    };
    const rebased = rebaseWind(old, next, 33);
    expect(rebased.waves.map((w, i) => w.phase === old.waves[i].phase)).toEqual([true, true, false, true]);
    expect(wavesAt(rebased, 33).phases[5]).toBeCloseTo(wavesAt(old, 33).phases[5], 6);
  });

  test('a phase that the edit sets is left as it is', () => {
    const old = presets.breeze;
    const next: Wind = { ...old, waves: old.waves.map((w) => ({ ...w, speed: 9, phase: 0.123 })) };
    expect(rebaseWind(old, next, 33).waves.map((w) => w.phase)).toEqual([0.123, 0.123, 0.123, 0.123]);
  });
});
