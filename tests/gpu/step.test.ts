import { expect, test } from 'vitest';
import { STEP, stepsAt } from '../../src/gpu/step.ts';

test('a time that is made of steps is a step, however it was rounded, also after hours', () => {
  for (const step of [0, 1, 7, 59, 60, 100_003, 5_000_000]) {
    for (const time of [step * STEP, step / 60, Math.fround(step / 60) === step / 60 ? step / 60 : step * STEP]) {
      expect(stepsAt(time)).toEqual({ first: step, last: step, fraction: 0 });
    }
  }
});

test('a time between two steps lies between them, as far as it is on its way', () => {
  const { first, last, fraction } = stepsAt(10.25 * STEP);
  expect([first, last]).toEqual([10, 11]);
  expect(fraction).toBeCloseTo(0.25, 9);
});

test('before the first step there is the first', () => {
  expect(stepsAt(-3)).toEqual({ first: 0, last: 0, fraction: 0 });
});
