import { expect, test } from 'vitest';
import { dampingRatio, freeDecay } from '../../src/gpu/crosscheck/free-decay.ts';

/** A damped oscillator let go at 1, by its closed form. */
function letGo(omega: number, ratio: number, step: number, count: number): Float64Array {
  const w = omega * Math.sqrt(1 - ratio * ratio);
  const b = (ratio * omega) / w;
  return Float64Array.from({ length: count }, (_, i) => {
    const t = i * step;
    return Math.exp(-ratio * omega * t) * (Math.cos(w * t) + b * Math.sin(w * t));
  });
}

test('frequency and damping of a closed form are found to a tenth of what is asked of the GPU', () => {
  for (const omega of [2, 5, 9, 12]) {
    for (const ratio of [0.03, 0.12, 0.25]) {
      const decay = freeDecay(letGo(omega, ratio, 1 / 60, 900), 1 / 60);
      const wanted = (2 * Math.PI) / (omega * Math.sqrt(1 - ratio * ratio));
      expect(decay.swings).toBeGreaterThan(0);
      expect(Math.abs(decay.period / wanted - 1)).toBeLessThan(1e-3);
      expect(Math.abs(dampingRatio(decay.decrement) / ratio - 1)).toBeLessThan(1e-3);
    }
  }
});

test('what does not swing has no period', () => {
  expect(freeDecay(letGo(3, 0.99, 1 / 60, 900), 1 / 60).swings).toBe(0);
  expect(freeDecay(new Float64Array(100), 1 / 60).swings).toBe(0);
});
