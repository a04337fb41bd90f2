import fc from 'fast-check';
import type { Cubic } from '../../../src/core/math/bezier.ts';
import { add, dot, length, type Vec3 } from '../../../src/core/math/vec3.ts';

const part = fc.double({ min: -1, max: 1, noNaN: true });

export const vector = fc.tuple(part, part, part) as fc.Arbitrary<Vec3>;

export const direction = vector
  .filter((v) => length(v) > 0.1)
  .map((v): Vec3 => {
    const n = length(v);
    return [v[0] / n, v[1] / n, v[2] / n];
  });

/** Any cubic, with edges that may vanish, be tiny, or turn back. */
export const anyCubic: fc.Arbitrary<Cubic> = fc
  .tuple(vector, fc.array(fc.tuple(vector, fc.constantFrom(0, 1e-9, 1e-3, 1, 1, 1)), { minLength: 3, maxLength: 3 }))
  .map(([p0, edges]) => {
    const points = [p0];
    for (const [e, s] of edges) points.push(add(points[points.length - 1], [e[0] * s, e[1] * s, e[2] * s]));
    return { p0: points[0], p1: points[1], p2: points[2], p3: points[3] };
  });

/** A cubic like a branch: edges of a third or so, joints of at most about 60 degrees. */
export const branchCubic: fc.Arbitrary<Cubic> = fc
  .tuple(direction, fc.array(vector, { minLength: 2, maxLength: 2 }), fc.double({ min: 0.1, max: 0.5, noNaN: true }))
  .map(([d, jitters, bend]) => {
    const p0: Vec3 = [0, 0, 0];
    const p1: Vec3 = [d[0] / 3, d[1] / 3, d[2] / 3];
    const next = (from: Vec3, along: Vec3, j: Vec3): [Vec3, Vec3] => {
      const e = add(along, [bend * j[0], bend * j[1], bend * j[2]]);
      const n = 3 * length(e);
      const u: Vec3 = [(3 * e[0]) / n, (3 * e[1]) / n, (3 * e[2]) / n];
      return [add(from, [u[0] / 3, u[1] / 3, u[2] / 3]), u];
    };
    const [p2, e2] = next(p1, d, jitters[0]);
    const [p3] = next(p2, e2, jitters[1]);
    return { p0, p1, p2, p3 };
  });

export const finite = (...vectors: Vec3[]): boolean => vectors.flat().every(Number.isFinite);

/** Largest deviation of three columns from an orthonormal right-handed frame. */
export const skew = (m: readonly Vec3[]): number =>
  Math.max(...[0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => Math.abs(dot(m[i], m[j]) - (i === j ? 1 : 0)))));
