import { describe, expect, test } from 'vitest';
import { parseWind } from '../../../src/core/wind/parse-wind.ts';
import { beaufortOf, forceOfSpeed, speedOfBeaufort, speedOfForce } from '../../../src/core/wind/speed.ts';
import { windToFile } from '../../../src/core/wind/wind-file.ts';
import { type WizardChoice, wizardWind } from '../../../src/core/wind/wizard.ts';
import { felt } from './force-over-time.ts';

const CHOICE: WizardChoice = { beaufort: 5, steadiness: 0.5, turbulence: 0.5, stiffness: 1, direction: 0.6, seed: 7 };
const NUMBERS = Array.from({ length: 12 }, (_, i) => i);

describe.each([
  [0, 0],
  [0, 1],
  [0.5, 0.5],
  [1, 0],
  [1, 1],
])('steadiness %d, turbulence %d', (steadiness, turbulence) => {
  test.each([1, 4, 8, 11])('Beaufort %d has its mean speed, towards its direction', (beaufort) => {
    const { mean } = felt(wizardWind({ ...CHOICE, beaufort, steadiness, turbulence }), 3000);
    const speed = speedOfForce(Math.hypot(...mean));
    expect(speed / speedOfBeaufort(beaufort)).toBeCloseTo(1, 1);
    expect(beaufortOf(speed).number).toBe(beaufort);
    expect(Math.atan2(mean[1], mean[0])).toBeCloseTo(CHOICE.direction, 1);
  });

  test('grows with Beaufort: mean, peak, and amplitude of every wave', () => {
    const winds = NUMBERS.map((beaufort) => wizardWind({ ...CHOICE, beaufort, steadiness, turbulence }));
    for (let i = 1; i < winds.length; i++) {
      const [before, after] = [felt(winds[i - 1], 200), felt(winds[i], 200)];
      expect(Math.hypot(...after.mean)).toBeGreaterThan(Math.hypot(...before.mean));
      expect(after.peak).toBeGreaterThan(before.peak);
      winds[i].waves.forEach((wave, n) => {
        expect(wave.amplitude).toBeGreaterThanOrEqual(winds[i - 1].waves[n].amplitude);
      });
    }
  });

  test('is a wind that a file can hold, of four to six waves', () => {
    for (const beaufort of [...NUMBERS, 3.5]) {
      const wind = wizardWind({ ...CHOICE, beaufort, steadiness, turbulence });
      expect(parseWind(windToFile(wind)).faults).toBeUndefined();
      expect(wind.waves.length).toBeGreaterThanOrEqual(4);
      expect(wind.waves.length).toBeLessThanOrEqual(6);
    }
  });
});

const unrest = (choice: Partial<WizardChoice>): number => {
  const { deviation, mean } = felt(wizardWind({ ...CHOICE, ...choice }), 1500);
  return deviation / Math.hypot(...mean);
};

test('steadiness takes the fluctuation away, turbulence adds some', () => {
  expect(unrest({ steadiness: 1, turbulence: 0 })).toBeLessThan(0.001);
  expect(unrest({ steadiness: 1, turbulence: 1 })).toBeLessThan(0.06);
  const rising = [1, 0.75, 0.5, 0.25, 0].map((steadiness) => unrest({ steadiness }));
  expect(rising).toEqual([...rising].sort((a, b) => a - b));
  expect(rising[4]).toBeGreaterThan(0.3);
  expect(unrest({ turbulence: 1 })).toBeGreaterThan(1.1 * unrest({ turbulence: 0 }));
});

test('gusts are long and slow, eddies short and quick, in a falling spectrum', () => {
  const [, ...waves] = wizardWind({ ...CHOICE, beaufort: 6, steadiness: 0, turbulence: 1 }).waves;
  const periods = waves.map(({ wavelength, speed }) => wavelength / speed);
  expect(periods).toEqual([...periods].sort((a, b) => b - a));
  expect(waves[0].amplitude).toBeGreaterThan(waves[1].amplitude);
  expect(waves[2].amplitude).toBeGreaterThan(waves[4].amplitude);
});

test('no two periods are in a ratio of small whole numbers', () => {
  for (const seed of [1, 2, 3, 4, 5]) {
    const [, ...waves] = wizardWind({ ...CHOICE, seed }).waves;
    const periods = waves.map(({ wavelength, speed }) => wavelength / speed);
    for (const a of periods)
      for (const b of periods) {
        if (a <= b) continue;
        for (const ratio of [1, 2, 3, 4]) expect(Math.abs(a / b / ratio - 1)).toBeGreaterThan(0.005);
      }
  }
});

test('is the same for the same seed, and of the same character for another', () => {
  expect(wizardWind(CHOICE)).toEqual(wizardWind({ ...CHOICE }));
  const other = wizardWind({ ...CHOICE, seed: 8 });
  expect(other).not.toEqual(wizardWind(CHOICE));
  expect(other.waves.map((w) => w.amplitude)).toEqual(
    wizardWind(CHOICE).waves.map((w) => expect.closeTo(w.amplitude, 12) as number),
  );
});

test('Beaufort 0 is still, and says so; stiffness is handed on', () => {
  const wind = wizardWind({ ...CHOICE, beaufort: 0, stiffness: 2.5 });
  expect(felt(wind, 20).peak).toBe(0);
  expect(wind).toMatchObject({ name: 'Beaufort 0', stiffness: 2.5, model: 'spring' });
  expect(wind.description).toMatch(/^Smoke rises/);
  expect(wind.waves[0].direction).toBe(CHOICE.direction);
});

test('the standing wave is a mean wind all over the meadow', () => {
  const wind = wizardWind({ ...CHOICE, steadiness: 1, turbulence: 0 });
  const here = Math.hypot(...felt(wind, 10).mean);
  expect(here).toBeCloseTo(forceOfSpeed(speedOfBeaufort(5)), 6);
  for (const angle of [0, 1, 2, 3, 4, 5, 6]) {
    const there = felt(wind, 10, [100 * Math.cos(angle), 100 * Math.sin(angle), 10]);
    expect(Math.hypot(...there.mean) / here).toBeGreaterThan(0.95);
  }
});
