import fc from 'fast-check';
import { expect, test } from 'vitest';
import {
  arcLength,
  bezierArcLength,
  bezierDerivative,
  bezierPoint,
  bezierSecondDerivative,
  type Cubic,
  holdArc,
  rescaleArc,
} from '../../../src/core/math/bezier.ts';
import { distance, scale, subtract, type Vec3 } from '../../../src/core/math/vec3.ts';
import { anyCubic, branchCubic, finite } from './curves.ts';

test('derivatives are those of the points', () => {
  fc.assert(
    fc.property(anyCubic, fc.double({ min: 0.01, max: 0.99, noNaN: true }), (c, u) => {
      const h = 1e-5;
      const slope = (f: (u: number) => Vec3): Vec3 => scale(subtract(f(u + h), f(u - h)), 1 / (2 * h));
      expect(
        distance(
          bezierDerivative(c, u),
          slope((x) => bezierPoint(c, x)),
        ),
      ).toBeLessThan(1e-7);
      expect(
        distance(
          bezierSecondDerivative(c, u),
          slope((x) => bezierDerivative(c, x)),
        ),
      ).toBeLessThan(1e-7);
    }),
  );
});

test('arc length is within 4e-5 of a fine polyline for branches', () => {
  fc.assert(
    fc.property(branchCubic, (c) => {
      let sum = 0;
      for (let i = 0; i < 2000; i++) sum += distance(bezierPoint(c, i / 2000), bezierPoint(c, (i + 1) / 2000));
      expect(Math.abs(bezierArcLength(c) / sum - 1)).toBeLessThan(4e-5);
    }),
    { numRuns: 20 },
  );
});

test('arc length holds to 1e-4 where edges fold by 105 degrees either way, and differ in length twice', () => {
  const angle = fc.double({ min: -1.83, max: 1.83, noNaN: true });
  const edge = fc.double({ min: 0.7, max: 1.4, noNaN: true });
  fc.assert(
    fc.property(angle, angle, edge, edge, (a, b, m, n) => {
      const p1: Vec3 = [1, 0, 0];
      const p2: Vec3 = [1 + m * Math.cos(a), m * Math.sin(a), 0];
      const c: Cubic = { p0: [0, 0, 0], p1, p2, p3: [p2[0] + n * Math.cos(a + b), p2[1] + n * Math.sin(a + b), 0] };
      let sum = 0;
      for (let i = 0; i < 2000; i++) sum += distance(bezierPoint(c, i / 2000), bezierPoint(c, (i + 1) / 2000));
      expect(Math.abs(arcLength(c) / sum - 1)).toBeLessThan(1e-4);
      expect(Math.abs(arcLength(holdArc(c, 2.5)) - 2.5)).toBeLessThan(1e-9);
    }),
    { numRuns: 60 },
  );
});

test('rescaling gives the length asked for, and never NaN', () => {
  fc.assert(
    fc.property(anyCubic, fc.double({ min: 0, max: 10, noNaN: true }), (c, rest) => {
      const r = rescaleArc(c, rest);
      expect(finite(r.p0, r.p1, r.p2, r.p3)).toBe(true);
      if (bezierArcLength(c) > 1e-6) expect(Math.abs(bezierArcLength(r) - rest)).toBeLessThan(1e-8 * (1 + rest));
    }),
  );
});
