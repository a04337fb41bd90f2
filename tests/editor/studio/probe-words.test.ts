import { describe, expect, test } from 'vitest';
import {
  lengthText,
  lengthUnit,
  niceRange,
  niceStep,
  smallLengthText,
  threeDigits,
} from '../../../src/editor/studio/units.ts';
import { placeText, summaryText, trustText } from '../../../src/editor/words/probe.ts';

const plain = (text: string): string => text.replaceAll('\u2009', ' ');

describe('numbers', () => {
  test('have about three digits and no negative nothing', () => {
    expect([123.4, 12.34, 1.234, -0.001, -2.5, 0].map(threeDigits)).toEqual([
      '123',
      '12.3',
      '1.23',
      '0.00',
      '\u22122.50',
      '0.00',
    ]);
  });

  test('of lengths come in the unit that suits them', () => {
    expect([0.004, 0.04, 4].map((m) => lengthUnit(m).unit)).toEqual(['mm', 'cm', 'm']);
    expect(plain(lengthText(-0.034))).toBe('\u22123.40 cm');
    expect(plain(smallLengthText(4.2e-7))).toBe('0.4 µm');
    expect(plain(smallLengthText(3.2e-5))).toBe('32 µm');
  });

  test('of axes end on round steps that hold the values', () => {
    expect(niceStep(10, 4)).toBe(5);
    expect(niceStep(0.7, 4)).toBeCloseTo(0.2, 12);
    for (const [low, high] of [
      [0, 4.7],
      [-0.3, 0.2],
      [3, 3],
      [-2e-4, 1e-4],
    ] as const) {
      const [from, to] = niceRange(low, high, 1e-5);
      expect(from).toBeLessThanOrEqual(low + 1e-12);
      expect(to).toBeGreaterThanOrEqual(high - 1e-12);
      expect(to).toBeGreaterThan(from);
    }
  });
});

describe('words', () => {
  const place = { piece: 3, level: 1, z0: 0.5, z1: 1, length: 2, height: 4.21, end: [0, 0, 4.21] as const };

  test('tell where the probe sits', () => {
    expect(plain(placeText(place))).toBe('the end of a limb, 4.2 m up');
    expect(plain(placeText({ ...place, level: 7, z1: 0.5 }))).toBe('50 % along a twig, 4.2 m up');
  });

  test('tell what the plots show', () => {
    const text = plain(
      summaryText(
        {
          seconds: 30,
          wind: { mean: 5, greatest: 10 },
          displacement: { mean: 0.02, greatest: 0.05 },
          velocity: { rms: 0.1, greatest: 0.3 },
          frequency: { wind: 0.25, displacement: null },
        },
        1.5,
      ),
    );
    expect(text).toContain(
      'The last 30 seconds: the wind at the probe has a mean of 5.00 m/s (gentle breeze) and reaches 10.0 m/s.',
    );
    expect(text).toContain(
      'leans 2.00 cm along the wind on average and gets at most 5.00 cm away from its rest, at up to 30.0 cm/s',
    );
    expect(text).toContain('The force is strongest at 0.25 Hz, the displacement at none.');
    expect(text).toContain('by itself swings at 1.50 Hz');
  });

  test('tell how far the numbers can be trusted', () => {
    expect(trustText(null)).toContain('Not yet');
    expect(plain(trustText({ difference: 2e-6, time: 3 }))).toContain(
      'At 3.00 s the GPU had the branch\u2019s end 2.0 µm from',
    );
  });
});
