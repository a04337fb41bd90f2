import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Cubic } from '../../../src/core/math/bezier.ts';
import {
  cross,
  distance,
  dot,
  length,
  type Mat3,
  scale,
  subtract,
  unit,
  type Vec3,
} from '../../../src/core/math/vec3.ts';
import {
  bendPiece,
  bendShare,
  bendStep,
  bendVector,
  bendWeights,
  directPush,
  FOLD,
  framePush,
  leanEdge,
  leanPiece,
  mixPush,
  type Push,
  paperBendStep,
  unfoldEdge,
} from '../../../src/core/wind/bend.ts';
import { branchCubic, finite, vector } from '../math/curves.ts';

const straight: Cubic = { p0: [0, 0, 0], p1: [0, 0, 1], p2: [0, 0, 2], p3: [0, 0, 3] };

const push = (second: Vec3, third: Vec3): Push => ({ second, third });
const degrees = (a: Vec3, b: Vec3): number => (Math.acos(dot(unit(a), unit(b))) * 180) / Math.PI;
const edges = (c: Cubic): [Vec3, Vec3, Vec3] => [subtract(c.p1, c.p0), subtract(c.p2, c.p1), subtract(c.p3, c.p2)];

describe('bending', () => {
  test.each([
    ['as it leans', leanPiece],
    ['as printed, with its units repaired', bendStep],
  ])('%s keeps the length of every edge, and P0 and P1', (_, bend) => {
    fc.assert(
      fc.property(branchCubic, vector, fc.double({ min: 0, max: 2, noNaN: true }), (c, a, gain) => {
        const bent = bend(c, push(scale(a, 0.14 * gain), scale(a, gain)));
        expect([bent.p0, bent.p1]).toEqual([c.p0, c.p1]);
        const [rest, now] = [edges(c), edges(bent)];
        for (const k of [1, 2]) expect(Math.abs(length(now[k]) - length(rest[k]))).toBeLessThan(1e-9);
        expect(finite(bent.p2, bent.p3)).toBe(true);
      }),
    );
  });

  test('by a push as long as the edge turns it by 45 degrees', () => {
    expect(degrees(leanEdge([0, 0, 2], [1, 0, 0]), [0, 0, 1])).toBeCloseTo(45, 9);
    expect(leanEdge([0, 0, 2], [0, 0, 5])).toEqual([0, 0, 2]);
  });

  test('against the very end of a branch leaves it as it is, and beside it nothing flips', () => {
    expect(leanPiece(straight, push([0, 0, -0.5], [0, 0, -5]))).toEqual(straight);
    fc.assert(
      fc.property(
        fc.double({ min: 0, max: 0.3, noNaN: true }),
        fc.double({ min: 0, max: 1e9, noNaN: true }),
        (a, gain) => {
          const wind: Vec3 = [gain * Math.sin(a), 0, -gain * Math.cos(a)];
          const leaning = leanEdge([0, 0, 1], wind);
          expect(length(leaning)).toBeCloseTo(1, 9);
          // At most at right angles to where it stood, and to the side to which it is pushed.
          expect(leaning[2]).toBeGreaterThanOrEqual(0);
          expect(leaning[0]).toBeGreaterThanOrEqual(0);
        },
      ),
    );
  });

  test('turns an edge steadily as the wind turns around it: no jump where it passes the tip or the side', () => {
    const around = (a: number): Vec3 => leanEdge([0, 0, 1], [4 * Math.sin(a), 0, 4 * Math.cos(a)]);
    for (let a = 0; a < 2 * Math.PI; a += 0.001) expect(degrees(around(a), around(a + 0.001))).toBeLessThan(0.3);
  });

  test('never beyond the direction of the wind, however hard it blows', () => {
    fc.assert(
      fc.property(vector, vector, fc.double({ min: 0, max: 1e6, noNaN: true }), (e, a, gain) => {
        fc.pre(length(e) > 1e-3 && length(a) > 1e-3 && dot(e, a) > 0);
        const wind = unit(a);
        const leaning = unit(leanEdge(e, scale(wind, gain)));
        const plane = cross(e, wind);
        expect(dot(cross(leaning, wind), plane)).toBeGreaterThan(-1e-9 * Math.max(1, dot(plane, plane)));
      }),
    );
  });

  test('folds no piece by more than 105 degrees, and changes none that folds less', () => {
    fc.assert(
      fc.property(vector, vector, (a, b) => {
        fc.pre(length(a) > 1e-3 && length(b) > 1e-3);
        const c = unfoldEdge(a, b, FOLD);
        const angle = degrees(a, b);
        if (angle < 105) expect(c).toEqual(b);
        if (angle > 105 && angle < 177) {
          expect(degrees(a, c)).toBeLessThan(105.2);
          expect(length(c)).toBeCloseTo(length(b), 9);
        }
        expect(length(c)).toBeLessThanOrEqual(length(b) * (1 + 1e-9));
      }),
    );
  });

  test('overflows in no single-precision number: a hair without stiffness in a storm without end', () => {
    const beta = bendVector(1e6, -1e6, 1e-7, 3, 2);
    expect(beta.every((x) => Number.isFinite(Math.fround(x)) && Math.abs(x) <= 1e4)).toBe(true);
    expect(Math.hypot(...beta)).toBeGreaterThan(9e3);
    expect(bendVector(0, 0, 0, 1.8, 2)).toEqual([0, 0, 0]);
  });

  test("in the paper's form the branch gets longer", () => {
    const { p2, p3 } = paperBendStep(straight, push([0.14, 0, 0], [1, 0, 0]));
    expect(distance(p2, p3)).toBeCloseTo(Math.SQRT2, 12);
  });
});

describe('pushes', () => {
  const model = { forceExponent: 1, lengthExponent: 0.6, softness: 0.5, paper: false };

  test('direct: the bend of the force by the weights and the softness', () => {
    const beta = bendVector(0.2, 0.1, 0.7, 1, 0.6);
    const { second, third } = directPush([0.2, 0.1], 0.7, [0.1, 0.8], model);
    expect(distance(second, scale(beta, 0.05))).toBeLessThan(1e-12);
    expect(distance(third, scale(beta, 0.4))).toBeLessThan(1e-12);
  });

  test('in a frame: along its columns', () => {
    const frame: Mat3 = [
      [0, 0, 1],
      [0, 1, 0],
      [-1, 0, 0],
    ];
    expect(framePush(frame, [1, 2, 3], [1, 0.5], 1)).toEqual({ second: [-3, 2, 1], third: [-1.5, 1, 0.5] });
  });

  test('fade from one into the other', () => {
    const [a, b] = [push([1, 0, 0], [0, 0, 0]), push([0, 1, 0], [2, 0, 0])];
    expect(mixPush(a, b, 0)).toEqual(a);
    expect(mixPush(a, b, 1)).toEqual(b);
    expect(mixPush(a, b, 0.25)).toEqual(push([0.75, 0.25, 0], [0.5, 0, 0]));
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
        const model = { forceExponent: 1, lengthExponent: 1, softness: 1, paper: false };
        const curve = bendPiece(c, directPush([0.1, 0], 1 / 3, bendWeights(k / n, (k + 1) / n), model), l);
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
