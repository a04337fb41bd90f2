import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { generatorCubic } from '../../../src/core/deform/generator.ts';
import { type Shape, stemRadius } from '../../../src/core/deform/radius.ts';
import { paperSurfacePoint, type SurfacePoint, surfacePoint } from '../../../src/core/deform/surface.ts';
import { bezierPoint, type Cubic } from '../../../src/core/math/bezier.ts';
import { handlesOf } from '../../../src/core/math/frames.ts';
import { cross, distance, dot, length, subtract, unit, type Vec3 } from '../../../src/core/math/vec3.ts';
import { anyCubic, branchCubic, finite, vector } from '../math/curves.ts';

const shape: Shape = { taper: 1.05, flare: 0.5, lobes: 5, lobeDepth: 0.08, lobeFade: 0.5, bulges: 3, bulgeDepth: 0.04 };
const O: Vec3 = [0, 1, 0.2];

function at(point: typeof surfacePoint, c: Cubic, u: number, turns: number, o: Vec3 = O): SurfacePoint {
  const [rho, byZ, q] = stemRadius(shape, 0.04, 1, u, turns);
  const a = 2 * Math.PI * turns;
  return point(c, handlesOf(c, o), u, Math.cos(a), Math.sin(a), rho, byZ, q);
}

/** The normal by central differences of the position, outward. */
function differenced(point: typeof surfacePoint, c: Cubic, u: number, turns: number, o: Vec3 = O): Vec3 {
  const h = 1e-5;
  const du = subtract(at(point, c, u + h, turns, o).position, at(point, c, u - h, turns, o).position);
  const dt = subtract(at(point, c, u, turns + h, o).position, at(point, c, u, turns - h, o).position);
  const n = unit(cross(dt, du));
  return dot(n, subtract(at(point, c, u, turns, o).position, bezierPoint(c, u))) < 0 ? [-n[0], -n[1], -n[2]] : n;
}

const degrees = (a: Vec3, b: Vec3): number => (Math.atan2(length(cross(a, b)), dot(a, b)) * 180) / Math.PI;

const places = [0.02, 0.2, 0.5, 0.77, 0.93].flatMap((u) => [0, 0.2, 0.45, 0.7].map((t) => [u, t] as const));

describe('normals against central differences', () => {
  test('exact for curves in a plane with T across it', () => {
    const c = generatorCubic(1, 0, 0.5, 0, 0.3);
    const o: Vec3 = [0, 0, 1];
    for (const [u, t] of places) {
      expect(degrees(at(surfacePoint, c, u, t, o).normal, differenced(surfacePoint, c, u, t, o))).toBeLessThan(1e-3);
    }
  });

  test('within 0.7 degrees for curves in space: the frame is taken not to twist', () => {
    fc.assert(
      fc.property(branchCubic, (c) => {
        for (const [u, t] of places) {
          expect(degrees(at(surfacePoint, c, u, t).normal, differenced(surfacePoint, c, u, t))).toBeLessThan(0.7);
        }
      }),
    );
  });

  test("the paper's surface: exact in space too", () => {
    fc.assert(
      fc.property(branchCubic, (c) => {
        for (const [u, t] of places) {
          expect(degrees(at(paperSurfacePoint, c, u, t).normal, differenced(paperSurfacePoint, c, u, t))).toBeLessThan(
            1e-3,
          );
        }
      }),
    );
  });
});

test('sections are circles at right angles to the curve', () => {
  const c = generatorCubic(1, 0, 0.7, 1, 0.6);
  const h = handlesOf(c, O);
  for (let i = 0; i < 16; i++) {
    const a = (i * Math.PI) / 8;
    const p = surfacePoint(c, h, 0.5, Math.cos(a), Math.sin(a), 0.05, 0, 0);
    expect(distance(p.position, bezierPoint(c, 0.5))).toBeCloseTo(0.05, 12);
    expect(distance(cross(p.normal, p.around), p.along)).toBeLessThan(1e-12);
  }
});

test.each([
  ['surfacePoint', surfacePoint],
  ['paperSurfacePoint', paperSurfacePoint],
])('%s: unit vectors and no NaN, whatever the curve and the radius', (_, point) => {
  fc.assert(
    fc.property(
      anyCubic,
      vector,
      fc.constantFrom(0, 0.3, 1),
      fc.constantFrom(0, 0.25, 0.6),
      fc.constantFrom(0, 1e-9, 0.05, 2),
      fc.constantFrom(0, -0.2, -1000),
      (c, o, u, turns, rho, rhoU) => {
        const a = 2 * Math.PI * turns;
        const p = point(c, handlesOf(c, o), u, Math.cos(a), Math.sin(a), rho, rhoU, 0.3);
        expect(finite(p.position, p.normal, p.around, p.along)).toBe(true);
        for (const v of [p.normal, p.around, p.along]) expect(length(v)).toBeCloseTo(1, 9);
      },
    ),
  );
});

test('the normal points outward even inside a fold', () => {
  const c = generatorCubic(1, 0, 1.4, 0, 1.4);
  const h = handlesOf(c, O);
  for (let i = 0; i < 16; i++) {
    const a = (i * Math.PI) / 8;
    const p = surfacePoint(c, h, 0.5, Math.cos(a), Math.sin(a), 0.6, 0, 0);
    expect(dot(p.normal, subtract(p.position, bezierPoint(c, 0.5)))).toBeGreaterThan(0);
  }
});

test('a rounded tip looks along the branch, a pointed one to its sides', () => {
  const c: Cubic = { p0: [0, 0, 0], p1: [0, 0, 1], p2: [0, 0, 2], p3: [0, 0, 3] };
  const h = handlesOf(c, [0, 1, 0]);
  const tip = (taper: number): Vec3 => {
    const [rho, byZ, q] = stemRadius({ ...shape, taper, lobeDepth: 0, bulgeDepth: 0 }, 0.3, 3, 1, 0);
    return surfacePoint(c, h, 1, 1, 0, rho, byZ, q).normal;
  };
  expect(tip(2)[2]).toBeGreaterThan(0.999);
  expect(tip(1)[1]).toBeGreaterThan(0.99);
});
