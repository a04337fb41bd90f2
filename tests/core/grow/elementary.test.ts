import fc from 'fast-check';
import { expect, test } from 'vitest';
import { atan2, power, sinCos, trig } from '../../../src/core/grow/elementary.ts';

const real = (min: number, max: number) => fc.double({ min, max, noNaN: true });

test('sine and cosine of any angle of a thousand turns', () => {
  fc.assert(
    fc.property(real(-6300, 6300), (angle) => {
      sinCos(angle);
      expect(Math.abs(trig.sin - Math.sin(angle))).toBeLessThan(2e-15);
      expect(Math.abs(trig.cos - Math.cos(angle))).toBeLessThan(2e-15);
    }),
  );
});

test('arc tangent of any direction', () => {
  fc.assert(
    fc.property(real(-10, 10), real(-10, 10), (y, x) => {
      expect(Math.abs(atan2(y, x) - (y === 0 ? Math.atan2(0, x) : Math.atan2(y, x)))).toBeLessThan(1e-15);
    }),
  );
  expect([atan2(0, 1), atan2(0, 0), atan2(0, -1), atan2(1, 0), atan2(-1, 0)]).toEqual([
    0,
    0,
    Math.PI,
    Math.PI / 2,
    -Math.PI / 2,
  ]);
});

test('powers of positive numbers', () => {
  fc.assert(
    fc.property(real(1e-9, 10), real(0, 10), (x, k) => {
      expect(Math.abs(power(x, k) / x ** k - 1)).toBeLessThan(1e-13);
    }),
  );
  expect([power(0, 0), power(0, 2), power(1, 7), power(0.3, 1)]).toEqual([1, 0, 1, 0.3]);
});
