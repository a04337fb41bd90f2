import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { parseAnemometer } from '../../../src/core/wind/anemometer.ts';
import { type KaimalWind, kaimalDensity, kaimalRecord } from '../../../src/core/wind/kaimal.ts';
import { spectrumOf } from '../../../src/core/wind/spectrum.ts';
import type { WindRecord } from '../../../src/core/wind/wind.ts';
import { shippedWind, windsFolder } from './shipped-winds.ts';

const WIND: KaimalWind = {
  meanSpeed: 8,
  intensity: 0.2,
  height: 10,
  seconds: 3000,
  step: 0.1,
  seed: 4,
  direction: 0.7,
};

/** Speed along the mean direction and across it. */
const parts = ({ speed, direction }: WindRecord, mean: number): [along: number[], across: number[]] => [
  speed.map((v, i) => v * Math.cos(direction[i] - mean)),
  speed.map((v, i) => v * Math.sin(direction[i] - mean)),
];
const meanOf = (values: readonly number[]): number => values.reduce((sum, v) => sum + v, 0) / values.length;
const deviationOf = (values: readonly number[]): number => {
  const mean = meanOf(values);
  return Math.sqrt(meanOf(values.map((v) => (v - mean) ** 2)));
};

/** Slope of a spectrum between two frequencies in a plot of logarithms: least squares. */
function slope(values: readonly number[], rate: number, from: number, to: number): number {
  const { frequency, power } = spectrumOf(values, rate, 512);
  const points = [...frequency].flatMap((f, k) => (f >= from && f <= to ? [[Math.log(f), Math.log(power[k])]] : []));
  const mx = meanOf(points.map(([x]) => x));
  const my = meanOf(points.map(([, y]) => y));
  const xy = points.reduce((sum, [x, y]) => sum + (x - mx) * (y - my), 0);
  return xy / points.reduce((sum, [x]) => sum + (x - mx) ** 2, 0);
}

describe("Kaimal's spectrum", () => {
  test('has all of its variance, and the power -5/3 at high frequencies', () => {
    let sum = 0;
    // Substituted f = tan^3: the tail falls so slowly that even steps would not reach its end.
    const steps = 200_000;
    for (let i = 0; i < steps; i++) {
      const t = (((i + 0.5) / steps) * Math.PI) / 2;
      const width = (3 * Math.tan(t) ** 2) / Math.cos(t) ** 2;
      sum += (kaimalDensity(Math.tan(t) ** 3, 56.7, 8) * width * (Math.PI / 2)) / steps;
    }
    expect(sum).toBeCloseTo(1, 3);
    const ratio = kaimalDensity(2000, 56.7, 8) / kaimalDensity(1000, 56.7, 8);
    expect(Math.log2(ratio)).toBeCloseTo(-5 / 3, 3);
  });

  test('is that of the record', () => {
    const [along, across] = parts(kaimalRecord(WIND), 0.7);
    for (const [values, length, deviation] of [
      [along, 8.1 * 7, 1.6],
      [across, 2.7 * 7, 0.8 * 1.6],
    ] as const) {
      const { frequency, power } = spectrumOf(values, 10, 512);
      for (const [from, to] of [
        [0.05, 0.2],
        [0.2, 0.8],
        [0.8, 3],
      ]) {
        const band = [...frequency].flatMap((f, k) => (f >= from && f < to ? [k] : []));
        const found = meanOf(band.map((k) => power[k]));
        const asked = meanOf(band.map((k) => deviation ** 2 * kaimalDensity(frequency[k], length, 8)));
        expect(found / asked).toBeGreaterThan(0.85);
        expect(found / asked).toBeLessThan(1.2);
      }
    }
  });

  test('falls with the power -5/3 where eddies break up', () => {
    const [along] = parts(kaimalRecord(WIND), 0.7);
    // Kaimal's own slope there is -1.61 to -1.65: it nears -5/3 from above.
    expect(slope(along, 10, 0.8, 4)).toBeGreaterThan(-1.75);
    expect(slope(along, 10, 0.8, 4)).toBeLessThan(-1.55);
  });
});

test('mean and deviation are those asked for, along and across', () => {
  for (const seed of [1, 2, 3]) {
    const record = kaimalRecord({ ...WIND, seed, seconds: 600, step: 0.2 });
    expect(record.speed).toHaveLength(3000);
    const [along, across] = parts(record, 0.7);
    expect(meanOf(along)).toBeCloseTo(8, 9);
    expect(deviationOf(along) / 8).toBeCloseTo(0.2, 9);
    expect(meanOf(across)).toBeCloseTo(0, 9);
    expect(deviationOf(across) / 8).toBeCloseTo(0.16, 9);
    // Gusts: the mean of a Gaussian's greatest of 3000 dependent samples is about three deviations.
    expect(Math.max(...along)).toBeGreaterThan(8 + 2.2 * 1.6);
    expect(Math.max(...along)).toBeLessThan(8 + 4.5 * 1.6);
  }
});

test('the same seed gives the same wind, another one another', () => {
  const short = { ...WIND, seconds: 60 };
  expect(kaimalRecord(short)).toEqual(kaimalRecord(short));
  expect(kaimalRecord({ ...short, seed: 5 }).speed).not.toEqual(kaimalRecord(short).speed);
});

test('higher up eddies are larger: the wind changes more slowly', () => {
  const change = (height: number): number => {
    const [along] = parts(kaimalRecord({ ...WIND, height, seconds: 600 }), 0.7);
    return deviationOf(along.slice(1).map((u, i) => u - along[i]));
  };
  expect(change(40)).toBeLessThan(0.8 * change(10));
});

describe('the sample that ships', () => {
  const text = readFileSync(join(windsFolder, 'kaimal-sample.csv'), 'utf8');

  test('is ten minutes at five a second, in less than 100 kB, without a remark to make', () => {
    expect(text.length).toBeLessThan(100_000);
    const { record, notes } = parseAnemometer(text, { name: 'Sample' });
    expect(notes).toEqual([]);
    expect(record).toMatchObject({ step: 0.2 });
    expect(record?.speed).toHaveLength(3000);
  });

  test('is what its remarks say', () => {
    const [, meanSpeed, intensity] = /Mean ([\d.]+) m\/s, turbulence intensity ([\d.]+)/.exec(text)!.map(Number);
    const record = shippedWind('recorded').record!;
    const towards = Math.atan2(meanOf(record.direction.map(Math.sin)), meanOf(record.direction.map(Math.cos)));
    const [along] = parts(record, towards);
    expect(meanOf(along)).toBeCloseTo(meanSpeed, 1);
    expect(deviationOf(along) / meanSpeed).toBeCloseTo(intensity, 2);
    expect(slope(along, 5, 0.4, 2)).toBeGreaterThan(-1.9);
    expect(slope(along, 5, 0.4, 2)).toBeLessThan(-1.4);
  });
});
