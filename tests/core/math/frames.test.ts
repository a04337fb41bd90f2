import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { handlesOf, projectedHandlesOf, sectionFrame, transport } from '../../../src/core/math/frames.ts';
import { addScaled, cross, distance, dot, length, type Vec3 } from '../../../src/core/math/vec3.ts';
import { attachByAngles } from '../../../src/core/wind/attach-angles.ts';
import { anyCubic, branchCubic, direction, finite, skew, vector } from './curves.ts';

describe('handles', () => {
  test.each([
    ['transported', handlesOf],
    ['projected', projectedHandlesOf],
  ])('%s: unit and at right angles to their edges, whatever the curve', (_, make) => {
    fc.assert(
      fc.property(anyCubic, vector, (c, o) => {
        const h = make(c, o);
        for (const [l, t] of [
          [h.l0, h.t0],
          [h.l1, h.t1],
          [h.l2, h.t2],
        ]) {
          expect(skew([l, t, cross(l, t)])).toBeLessThan(1e-9);
        }
      }),
    );
  });

  test('a straight curve keeps T from end to end', () => {
    const h = handlesOf({ p0: [0, 0, 0], p1: [0, 0, 1], p2: [0, 0, 2], p3: [0, 0, 3] }, [0, 2, 1]);
    expect([h.t0, h.t1, h.t2]).toEqual([
      [0, 1, 0],
      [0, 1, 0],
      [0, 1, 0],
    ]);
  });

  test('an edge without length takes the direction of its neighbour', () => {
    const h = handlesOf({ p0: [0, 0, 0], p1: [0, 0, 1], p2: [0, 0, 1], p3: [0, 0, 1] }, [0, 1, 0]);
    expect([h.l0, h.l1, h.l2]).toEqual([
      [0, 0, 1],
      [0, 0, 1],
      [0, 0, 1],
    ]);
  });
});

describe('transport', () => {
  test('is a rotation: it keeps the angle to the tangent and between vectors', () => {
    fc.assert(
      fc.property(direction, direction, vector, (p, q, a) => {
        const across = addScaled(a, p, -dot(a, p));
        fc.pre(length(across) > 0.01 && dot(p, q) > -0.999);
        const n = length(across);
        const t: Vec3 = [across[0] / n, across[1] / n, across[2] / n];
        const moved = transport(t, p, q);
        const other = transport(cross(p, t), p, q);
        expect(skew([q, moved, other])).toBeLessThan(1e-9);
        expect(distance(cross(q, moved), other)).toBeLessThan(1e-9);
      }),
    );
  });

  test('there and back again is where it began', () => {
    fc.assert(
      fc.property(direction, direction, (p, q) => {
        fc.pre(dot(p, q) > -0.99 && Math.abs(p[2]) < 0.9);
        const t = transport([0, 0, 1], [0, 1, 0], p);
        expect(distance(transport(transport(t, p, q), q, p), t)).toBeLessThan(1e-9);
      }),
    );
  });
});

describe('section frame', () => {
  test('is orthonormal and right-handed for every curve and place', () => {
    fc.assert(
      fc.property(anyCubic, vector, fc.double({ min: 0, max: 1, noNaN: true }), (c, o, u) => {
        const m = sectionFrame(c, handlesOf(c, o), u);
        expect(finite(...m)).toBe(true);
        expect(skew(m)).toBeLessThan(1e-9);
        expect(distance(cross(m[0], m[1]), m[2])).toBeLessThan(1e-9);
      }),
    );
  });

  test('at the ends is the frame of the first and the last edge', () => {
    fc.assert(
      fc.property(branchCubic, vector, (c, o) => {
        const h = handlesOf(c, o);
        const [first, last] = [sectionFrame(c, h, 0), sectionFrame(c, h, 1)];
        expect(Math.max(distance(first[0], h.l0), distance(first[1], h.t0))).toBeLessThan(1e-9);
        expect(Math.max(distance(last[0], h.l2), distance(last[1], h.t2))).toBeLessThan(1e-9);
      }),
    );
  });

  test('turns little from place to place', () => {
    fc.assert(
      fc.property(branchCubic, vector, (c, o) => {
        const h = handlesOf(c, o);
        for (let i = 0; i < 100; i++) {
          const [a, b] = [sectionFrame(c, h, i / 100), sectionFrame(c, h, (i + 1) / 100)];
          expect(Math.max(distance(a[0], b[0]), distance(a[1], b[1]))).toBeLessThan(0.1);
        }
      }),
    );
  });
});

test('the orientation of a branch is smooth where its angle to the parent passes 0', () => {
  const parent = { p0: [0, 0, 0], p1: [0.1, 0, 0.4], p2: [0.3, 0.1, 0.7], p3: [0.6, 0.1, 0.9] } as const;
  const c = { p0: [...parent.p0], p1: [...parent.p1], p2: [...parent.p2], p3: [...parent.p3] } as never;
  const local = { p0: [0, 0, 0], p1: [1, 0, 0], p2: [2, 0, 0], p3: [3, 0, 0] } as never;
  const at = (alpha: number) => attachByAngles(c, [0, 1, 0], 0.4, { theta: 0.7, alpha, roll: 0 }, local);
  for (let alpha = -0.05; alpha < 0.05; alpha += 0.001) {
    const [a, b] = [at(alpha), at(alpha + 0.001)];
    expect(distance(handlesOf(a.curve, a.o).t0, handlesOf(b.curve, b.o).t0)).toBeLessThan(0.002);
  }
});
