import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Cubic } from '../../../src/core/math/bezier.ts';
import { distance } from '../../../src/core/math/vec3.ts';
import { bendPiece, bendShare, bendStep, bendVector, bendWeights, paperBendStep } from '../../../src/core/wind/bend.ts';
import { anyCubic, finite, vector } from '../math/curves.ts';

const straight: Cubic = { p0: [0, 0, 0], p1: [0, 0, 1], p2: [0, 0, 2], p3: [0, 0, 3] };

describe('bending', () => {
  test('keeps the length of every edge, and P0 and P1', () => {
    fc.assert(
      fc.property(anyCubic, vector, fc.double({ min: 0, max: 100, noNaN: true }), (c, push, gain) => {
        const { curve, angle } = bendStep(c, [push[0] * gain, push[1] * gain, push[2] * gain], 0.14, 1);
        expect([curve.p0, curve.p1]).toEqual([c.p0, c.p1]);
        expect(Math.abs(distance(curve.p1, curve.p2) - distance(c.p1, c.p2))).toBeLessThan(1e-9);
        expect(Math.abs(distance(curve.p2, curve.p3) - distance(c.p2, c.p3))).toBeLessThan(1e-9);
        expect(finite(curve.p2, curve.p3) && Number.isFinite(angle)).toBe(true);
      }),
    );
  });

  test('against the very end of a branch leaves it as it is', () => {
    expect(bendStep(straight, [0, 0, -1], 1, 1).curve).toEqual(straight);
  });

  test('by a push as long as the edge turns it by 45 degrees', () => {
    expect(bendStep(straight, [1, 0, 0], 0, 1).angle).toBeCloseTo(Math.PI / 4, 2);
  });

  test("in the paper's form the branch gets longer", () => {
    const { curve } = paperBendStep(straight, [1, 0, 0], 0.14, 1);
    expect(distance(curve.p2, curve.p3)).toBeCloseTo(Math.SQRT2, 12);
  });
});

describe('bend of a force', () => {
  test('divides by the length to the power m', () => {
    expect(bendVector(0.2, 0, 0.5, 1, 0)[0]).toBeCloseTo(0.2, 12);
    expect(bendVector(0.2, 0, 0.5, 1, 1)[0]).toBeCloseTo(0.4, 12);
    expect(bendVector(0.2, 0, 0.5, 1, 2)[0]).toBeCloseTo(0.8, 12);
  });

  test('grows with the power p of the force, in its direction', () => {
    const [x, y, z] = bendVector(0.3, 0.4, 1, 1.8, 0);
    expect(Math.hypot(x, y)).toBeCloseTo(0.5 ** 1.8, 12);
    expect(y / x).toBeCloseTo(4 / 3, 12);
    expect(z).toBe(0);
    expect(bendVector(0, 0, 1, 1.8, 1)).toEqual([0, 0, 0]);
  });
});

describe('weights of a chain', () => {
  test('add up to those of the whole stem', () => {
    for (const n of [1, 2, 3, 7]) {
      let sum = 0;
      for (let k = 0; k < n; k++) sum += bendWeights(k / n, (k + 1) / n)[1];
      expect(sum).toBeCloseTo(1, 12);
    }
    expect(bendWeights(0, 1)[0]).toBeCloseTo(bendShare(1 / 3), 12);
  });

  test('bend a stem to the same tip however many pieces it has', () => {
    // A straight stem of 1 m in n pieces, posed one on the other: the tip of each as equations.md 7.4 gives it.
    const tips = [1, 2, 3, 4].map((n) => {
      let x = 0;
      let angle = 0;
      for (let k = 0; k < n; k++) {
        const l = 1 / n;
        const along = [Math.sin(angle), Math.cos(angle)];
        const point = (s: number): [number, number, number] => [s * along[0], 0, s * along[1]];
        const c: Cubic = { p0: [0, 0, 0], p1: point(l / 3), p2: point((2 * l) / 3), p3: point(l) };
        const { curve } = bendPiece(c, [0.1, 0], 1 / 3, bendWeights(k / n, (k + 1) / n), l, {
          forceExponent: 1,
          lengthExponent: 1,
          paper: false,
        });
        x += curve.p3[0];
        angle = Math.atan2(curve.p3[0] - curve.p2[0], curve.p3[2] - curve.p2[2]);
      }
      return { x, degrees: (angle * 180) / Math.PI };
    });
    for (const { x, degrees } of tips) {
      expect(x).toBeGreaterThan(0.1);
      expect(x).toBeLessThan(0.115);
      expect(Math.abs(degrees - 16.8)).toBeLessThan(0.2);
    }
  });
});
