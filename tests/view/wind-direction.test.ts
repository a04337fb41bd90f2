import { expect, test } from 'vitest';
import { DEFAULT_WAVE, STILL, type Wave } from '../../src/core/wind/wind.ts';
import { windDirection } from '../../src/view/wind-direction.ts';

const wave = (change: Partial<Wave>): Wave => ({ ...DEFAULT_WAVE, ...change });

test('is that of the waves that blow, the stronger counting more', () => {
  const waves = [wave({ amplitude: 3, direction: 0 }), wave({ amplitude: 3, direction: Math.PI / 2 })];
  expect(windDirection({ ...STILL, waves })).toBeCloseTo(Math.PI / 4, 12);
  expect(windDirection({ ...STILL, waves: [...waves, wave({ on: false, direction: 3 })] })).toBeCloseTo(
    Math.PI / 4,
    12,
  );
  expect(windDirection({ ...STILL, waves: [...waves, wave({ solo: true, direction: 2 })] })).toBeCloseTo(2, 12);
});

test('is the mean of a record where no wave blows, and none where nothing does', () => {
  const record = { name: 'sample', step: 1, speed: [1, 3], direction: [0, Math.PI / 2] };
  expect(windDirection({ ...STILL, record })).toBeCloseTo(Math.atan2(3, 1), 12);
  expect(windDirection(STILL)).toBeNull();
});
