import { describe, expect, test } from 'vitest';
import { generatorCubic } from '../../src/core/deform/generator.ts';
import { surfacePoint } from '../../src/core/deform/surface.ts';
import { isLinkKey } from '../../src/core/link/link.ts';
import { bezierPoint } from '../../src/core/math/bezier.ts';
import { handlesOf } from '../../src/core/math/frames.ts';
import { distance, dot, scale, subtract, type Vec3 } from '../../src/core/math/vec3.ts';
import { mayBe } from '../../src/core/species/edits.ts';
import { bentPoint, rolledPoint, stagePoint } from '../../src/learn/branch-deformer/branch-mesh.ts';
import { branchOf, DEGREE, PARENT, SHAPES, walk } from '../../src/learn/branch-deformer/example-branch.ts';
import { turnedBy } from '../../src/learn/branch-deformer/figure-frames.ts';
import { LOBES_FIGURE } from '../../src/learn/branch-deformer/figure-lobes.ts';
import { PROFILE_FIGURE } from '../../src/learn/branch-deformer/figure-profile.ts';
import { bow, curvature, halfAxes } from '../../src/learn/branch-deformer/figure-section.ts';
import { cutOfSides } from '../../src/learn/branch-deformer/figure-sheet.ts';
import { differenced, FACTORS } from '../../src/learn/branch-deformer/figure-slope.ts';
import { twistAt } from '../../src/learn/branch-deformer/figure-twist.ts';
import { missingFactor, WALK_FIGURE } from '../../src/learn/branch-deformer/figure-walk.ts';
import { nearestValue } from '../../src/learn/branch-deformer/nearest-value.ts';
import { degreesBetween, differencedNormal, NORMALS } from '../../src/learn/branch-deformer/normal-error.ts';
import {
  construction,
  mostTwist,
  printedFlareSlope,
  printedGap,
  printedHandleLengths,
  printedJacobian,
  printedLobesByAngle,
} from '../../src/learn/branch-deformer/printed.ts';

const curve = walk(2, 48, -30, 30);
const handles = handlesOf(curve, PARENT);

describe('slopes', () => {
  test.each(Object.entries(FACTORS))('%s: corrected is the slope of the curve, printed is not', (_, factor) => {
    for (const share of [0.05, 0.3, 0.63, 0.9]) {
      const x = factor.x[0] + share * (factor.x[1] - factor.x[0]);
      expect(factor.slope(x)).toBeCloseTo(differenced(factor, x), 5);
      expect(Math.abs(factor.printed(x) - differenced(factor, x))).toBeGreaterThan(0.001);
    }
  });

  test('the numbers that the text quotes', () => {
    expect(printedFlareSlope(0, 0.33)).toBeCloseTo(-3684.1, 1);
    expect(FACTORS.flare?.slope(0)).toBeCloseTo(-12.158, 3);
    expect(printedLobesByAngle(0.5, 0.3, 7, 0.2, 1)).toBeCloseTo(1.06, 3);
    expect(FACTORS.lobes?.slope(0.3)).toBeCloseTo(-0.353, 3);
  });
});

describe('de Casteljau', () => {
  const at = (u: number, v: number, w: number): Vec3 => construction(curve, handles, u, v, w).point;

  test('the construction is the deformer; as printed in 2007 the branch begins a third of an edge late', () => {
    expect(distance(at(0, 0, 0), curve.p0)).toBeLessThan(1e-12);
    expect(distance(at(0.4, 0, 0), bezierPoint(curve, 0.4))).toBeLessThan(1e-12);
    expect(printedGap(curve, handles)).toBeCloseTo(distance(curve.p1, curve.p0), 9);
  });

  test("equation 15 as printed is not the construction's derivative", () => {
    const [u, v, w] = [0.5, 0.1, 0.07];
    const h = 1e-5;
    const by = (a: Vec3, b: Vec3): Vec3 => scale(subtract(a, b), 1 / (2 * h));
    const byU = by(at(u + h, v, w), at(u - h, v, w));
    const byW = by(at(u, v, w + h), at(u, v, w - h));
    const printed = printedJacobian(curve, handles, u, v, w);
    expect(distance(printed.byU, byU)).toBeGreaterThan(0.05);
    expect(distance(printed.byW, byW)).toBeGreaterThan(0.3);
  });
});

describe('frames', () => {
  test.each([
    [20, 1.8],
    [45, 9.9],
    [75, 36],
  ])('a joint of %d degrees twists by at most %d, as the closed form says', (beta, most) => {
    const twists = Array.from({ length: 361 }, (_, i) => Math.abs(twistAt(beta, i / 2)));
    expect(Math.max(...twists)).toBeCloseTo(mostTwist(beta * DEGREE) / DEGREE, 2);
    expect(Math.max(...twists)).toBeCloseTo(most, 0);
  });

  test('the projected arrow flips beyond a right angle, the one that leans on a fixed direction where an edge points there', () => {
    expect(Math.abs(twistAt(89.9, 0))).toBeLessThan(1e-6);
    expect(Math.abs(twistAt(90.1, 0))).toBeCloseTo(180, 6);
    expect(Math.abs(turnedBy('fixed', 89, 90)[0])).toBeLessThan(1e-6);
    expect(Math.abs(turnedBy('fixed', 91, 90)[0])).toBeCloseTo(180, 6);
    expect(turnedBy('transport', 120, 40)).toEqual([0, 0]);
  });

  test('a joint of 60 degrees towards S halves the handles that are not made unit vectors', () => {
    const [t0, t1] = printedHandleLengths(generatorCubic(1, 0, 60 * DEGREE, 0, 0), PARENT);
    expect([t0, t1]).toEqual([expect.closeTo(1, 12), expect.closeTo(0.5, 12)]);
  });
});

describe('sections', () => {
  test.each([0, 45, 60])(
    "the paper's pinch by (1 + cos b)/2 at %d degrees, ours are circles across the tangent",
    (bend) => {
      const [inPlane, across] = halfAxes(bend, 0.5);
      expect(inPlane).toBeCloseTo((1 + Math.cos(bend * DEGREE)) / 2, 12);
      expect(across).toBeCloseTo(1, 12);
      const c = bow(bend);
      const point = surfacePoint(c, handlesOf(c, PARENT), 0.5, 0.6, 0.8, 0.1, 0, 0);
      expect(distance(point.position, bezierPoint(c, 0.5))).toBeCloseTo(0.1, 12);
      expect(dot(subtract(point.position, bezierPoint(c, 0.5)), point.along)).toBeCloseTo(0, 12);
    },
  );

  test('curvature is that of a circle where the curve is nearly one', () => {
    expect(curvature(bow(5), 0.5)).toBeCloseTo((2 * 5 * DEGREE * 3) / 4, 1);
    const { p0, p1, p2, p3 } = bow(40);
    const twice = { p0: scale(p0, 2), p1: scale(p1, 2), p2: scale(p2, 2), p3: scale(p3, 2) };
    expect(curvature(twice, 0.3)).toBeCloseTo(curvature(bow(40), 0.3) / 2, 12);
  });
});

describe('normals', () => {
  const branch = branchOf(SHAPES.knobbly, 0.2, curve);
  const errors = (way: string): number[] =>
    [0.05, 0.21, 0.5, 0.78, 0.95].flatMap((u) =>
      [0.02, 0.3, 0.6, 0.85].map((turns) =>
        degreesBetween(
          (NORMALS[way] as (typeof NORMALS)[string])(branch, u, turns),
          differencedNormal(branch, u, turns),
        ),
      ),
    );

  test('by the Jacobian they are right, from the axis they are not, as printed they point inward', () => {
    expect(Math.max(...errors('jacobian'))).toBeLessThan(1e-3);
    expect(Math.max(...errors('naive'))).toBeGreaterThan(20);
    expect(Math.min(...errors('printed'))).toBeGreaterThan(179.99);
  });
});

describe('open in editor', () => {
  test.each([PROFILE_FIGURE, LOBES_FIGURE, WALK_FIGURE])('$id: the editor takes every link', ({ controls, open }) => {
    for (const end of ['min', 'value', 'max'] as const) {
      const values = Object.fromEntries(
        controls.map((control) => [control.id, 'min' in control ? control[end] : control.value]),
      );
      for (const [key, value] of new URLSearchParams(open?.(values))) {
        expect([key, isLinkKey(key)]).toEqual([key, true]);
        if (key.includes('.')) expect([key, value, mayBe(key, Number(value))]).toEqual([key, value, true]);
      }
    }
  });
});

describe('sheet and walk', () => {
  test('a sheet keeps its width as it rolls, and closes to a circle', () => {
    for (const rolled of [0, 0.3, 1]) {
      const points = Array.from({ length: 2001 }, (_, i) => rolledPoint(0.4, i / 2000, 2, 0.3, rolled).position);
      const width = points.slice(1).reduce((sum, p, i) => sum + distance(p, points[i] as Vec3), 0);
      expect(width).toBeCloseTo(2 * Math.PI * 0.3, 4);
    }
    expect(distance(rolledPoint(0.4, 0, 2, 0.3, 1).position, rolledPoint(0.4, 1, 2, 0.3, 1).position)).toBeLessThan(
      1e-12,
    );
  });

  test('the way from sheet to branch has no jump, and ends at what the deformer makes', () => {
    const branch = branchOf(SHAPES.limb, 0.16, curve);
    for (const step of [1, 2, 3]) {
      const [before, after] = [step - 1e-9, step].map((at) => stagePoint(branch, 2, at, 0.37, 0.2).position) as [
        Vec3,
        Vec3,
      ];
      expect(distance(before, after)).toBeLessThan(1e-7);
    }
    expect(stagePoint(branch, 2, 3, 0.37, 0.2).position).toEqual(bentPoint(branch, 0.37, 0.2).position);
    // The cylinder is the branch's own where nothing shapes it: the same side is theta = 0.
    const cylinder = branchOf({ ...SHAPES.cone, taper: 0 }, 0.16, curve);
    expect(
      distance(stagePoint(cylinder, 2, 1, 0.37, 0.2).position, stagePoint(cylinder, 2, 2, 0.37, 0.2).position),
    ).toBeLessThan(1e-9);
  });

  test('twelve flat sides cut in by 3.4 percent; edges grow by 1.108 for two joints of 45 degrees', () => {
    expect(cutOfSides(12)).toBeCloseTo(0.0341, 4);
    expect(missingFactor(45, 45)).toBeCloseTo(1 / 0.9024, 3);
  });

  test('a handle takes the value that brings it nearest', () => {
    expect(nearestValue(-85, 85, 1, (x) => Math.abs(x - 12.4))).toBe(12);
  });
});
