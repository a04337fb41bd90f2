import { describe, expect, test } from 'vitest';
import { angleOfChord, cosTurns, power, sinTurns } from '../../../src/core/math/trig.ts';

const TAU = 2 * Math.PI;
/** Turns from -3 to 3 and the places where the branches of the code meet. */
const turns = [...Array.from({ length: 1201 }, (_, i) => (i - 600) / 200 + 0.0007), -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1];

describe('sine and cosine of turns', () => {
  test('are within 2e-11 of the true ones in double', () => {
    const worst = Math.max(
      ...turns.map((x) => Math.abs(sinTurns(x) - Math.sin(TAU * x))),
      ...turns.map((x) => Math.abs(cosTurns(x) - Math.cos(TAU * x))),
    );
    expect(worst).toBeLessThan(2e-11);
  });

  test('are within 6e-7 of the true ones when every step is rounded to float32', () => {
    const f = Math.fround;
    const c = [
      6.28318530648751, -41.3417019297741, 81.60520943120132, -76.70366783199628, 41.9999898947871, -14.337025069807426,
    ];
    let worst = 0;
    for (let i = 0; i <= 4000; i++) {
      const y = f(i / 16000);
      const s = f(y * y);
      const sum = c.map(f).reduceRight((acc, k) => f(k + f(s * acc)), 0);
      worst = Math.max(worst, Math.abs(f(y * sum) - Math.sin(TAU * y)));
    }
    expect(worst).toBeLessThan(6e-7);
  });

  test('keep small sines to their last digit, and whole turns are 0', () => {
    expect(sinTurns(1e-9) / (TAU * 1e-9)).toBeCloseTo(1, 9);
    expect(sinTurns(5)).toBe(0);
    expect(sinTurns(-0.5)).toBeCloseTo(0, 15);
  });
});

test('a power of 0 is 0, of 1 is 1', () => {
  expect([power(0, 0.5), power(0, 3), power(1, 2.5), power(-1, 2)]).toEqual([0, 0, 1, 0]);
  expect(power(0.3, 1.8)).toBeCloseTo(0.3 ** 1.8, 14);
});

test('the angle of a chord is within 0.1 % up to 120 degrees', () => {
  for (let a = 0.01; a < (2 * Math.PI) / 3; a += 0.01) {
    expect(Math.abs(angleOfChord(2 * Math.sin(a / 2)) / a - 1)).toBeLessThan(1e-3);
  }
});
