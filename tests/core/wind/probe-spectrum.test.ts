import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { hashPcg, hashUnit } from '../../../src/core/math/hash.ts';
import { dominantFrequency, spectrumOf } from '../../../src/core/wind/spectrum.ts';

const sine = (n: number, hertz: number, amplitude: number, rate = 60): number[] =>
  Array.from({ length: n }, (_, i) => 5 + amplitude * Math.sin((2 * Math.PI * hertz * i) / rate));

const noise = (n: number): number[] => Array.from({ length: n }, (_, i) => hashUnit(hashPcg(i)) - 0.5);

/** The variance that a spectrum says. */
const variance = ({ frequency, power }: ReturnType<typeof spectrumOf>): number =>
  power.reduce((sum, p) => sum + p, 0) * frequency[1];

describe('spectrum', () => {
  test('has the variance of a sine: half of its amplitude squared', () => {
    expect(variance(spectrumOf(sine(3600, 3.75, 0.4), 60))).toBeCloseTo(0.08, 3);
  });

  test('of white noise is flat: each tenth of it has a tenth of the variance', () => {
    const spectrum = spectrumOf(noise(1 << 16), 60);
    expect(variance(spectrum)).toBeCloseTo(1 / 12, 2);
    const tenth = Math.floor(spectrum.power.length / 10);
    for (let k = 0; k < 10; k++) {
      const share = spectrum.power.subarray(k * tenth + 1, (k + 1) * tenth).reduce((sum, p) => sum + p, 0);
      expect((share * spectrum.frequency[1]) / (1 / 12)).toBeCloseTo(0.1, 1);
    }
  });

  test('finds a frequency between its bins', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0.3, max: 20, noNaN: true }),
        fc.double({ min: 0.01, max: 10, noNaN: true }),
        (f, a) => {
          const spectrum = spectrumOf(sine(3600, f, a), 60);
          expect(Math.abs(dominantFrequency(spectrum)! - f)).toBeLessThan(0.1 * spectrum.frequency[1]);
        },
      ),
      { numRuns: 30 },
    );
  });

  test('does not see the mean, and nothing in what stands still', () => {
    expect(dominantFrequency(spectrumOf(new Float64Array(600).fill(3), 60))).toBeNull();
    expect(spectrumOf(new Float64Array(8), 60).power).toHaveLength(0);
    expect(dominantFrequency(spectrumOf([], 60))).toBeNull();
  });

  test('of a short stretch takes the longest segment that fits', () => {
    expect(spectrumOf(sine(100, 5, 1), 60).frequency).toHaveLength(33);
    expect(spectrumOf(sine(100, 5, 1), 60).frequency[32]).toBe(30);
  });
});
