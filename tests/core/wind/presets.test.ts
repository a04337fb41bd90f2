import { expect, test } from 'vitest';
import { DEFAULT_WIND, presets } from '../../../src/core/wind/presets.ts';

const blowing = ['light-air', 'breeze', 'fresh-breeze', 'gale'];
const total = (name: string): number => presets[name].waves.reduce((sum, w) => sum + w.amplitude, 0);

test('there are five winds, each under its name', () => {
  expect(Object.keys(presets)).toEqual(['still', ...blowing]);
  for (const [name, wind] of Object.entries(presets)) expect(wind.name).toBe(name);
  expect(presets[DEFAULT_WIND].strength).toBe(1);
  expect(presets.still.strength).toBe(0);
});

test('each has four waves of the kind that the papers ask for', () => {
  for (const name of blowing) {
    const { waves } = presets[name];
    expect(waves).toHaveLength(4);
    for (const wave of waves) {
      expect(wave.wavelength).toBeGreaterThanOrEqual(6);
      expect(wave.wavelength).toBeLessThanOrEqual(60);
      expect(wave.speed).toBeGreaterThanOrEqual(2);
      expect(wave.speed).toBeLessThanOrEqual(15);
      expect(wave.sharpness).toBeGreaterThanOrEqual(1.5);
      expect(wave.sharpness).toBeLessThanOrEqual(3);
    }
  }
});

test('the first wave is the gust: longest, slowest to pass, strongest', () => {
  for (const name of blowing) {
    const [gust, ...others] = presets[name].waves;
    for (const wave of others) {
      expect(gust.amplitude).toBeGreaterThan(wave.amplitude);
      expect(gust.wavelength).toBeGreaterThan(wave.wavelength);
      expect(gust.wavelength / gust.speed).toBeGreaterThan(wave.wavelength / wave.speed);
    }
  }
});

test('they are ordered from weak to strong', () => {
  for (let i = 1; i < blowing.length; i++) expect(total(blowing[i])).toBeGreaterThan(1.5 * total(blowing[i - 1]));
});
