import { describe, expect, it } from 'vitest';
import { FITTED, fitCubicFree } from '../../../src/core/pieces/fit.ts';

/** Points of a cubic from the origin along z, at uneven parameters. */
function pointsOf(p1: number[], p2: number[], p3: number[], parameters: number[]): Float64Array {
  return Float64Array.from(
    parameters.flatMap((u) =>
      [0, 1, 2].map((k) => 3 * (1 - u) ** 2 * u * p1[k] + 3 * (1 - u) * u * u * p2[k] + u ** 3 * p3[k]),
    ),
  );
}

describe('fitCubicFree', () => {
  const fitted = (points: Float64Array, enough: number): { out: Float64Array; worst: number } => {
    const out = new Float64Array(FITTED);
    const last = points.length / 3 - 1;
    return { worst: fitCubicFree(points, 0, last, 0, 0, 1, 0, 0, 1, enough, out), out };
  };

  it('comes close to a cubic from points on it', () => {
    const p3 = [0.8, -0.3, 2.2];
    const points = pointsOf([0, 0, 0.9], [0.5, 0, 1.6], p3, [0, 0.1, 0.2, 0.35, 0.5, 0.6, 0.7, 0.85, 1]);
    const { out, worst } = fitted(points, 0);
    expect(worst).toBeLessThan(0.006);
    expect(Array.from(out.subarray(6, 9))).toEqual(p3);
    expect(out[0]).toBe(0);
    expect(out[1]).toBe(0);
    expect(out[2]).toBeGreaterThan(0.5);
  });

  it('is scale-free', () => {
    const points = pointsOf([0, 0, 0.9], [0.5, 0, 1.6], [0.8, -0.3, 2.2], [0, 0.2, 0.45, 0.7, 1]);
    const small = fitted(
      points.map((x) => 0.01 * x),
      0,
    );
    const large = fitted(points, 0);
    for (let k = 0; k < 9; k++) expect(100 * small.out[k]).toBeCloseTo(large.out[k], 9);
  });

  it('draws a plain curve between two nodes, along both directions given', () => {
    const out = new Float64Array(FITTED);
    fitCubicFree(Float64Array.of(0, 0, 0, 0.3, 0, 0.9), 0, 1, 0, 0, 1, 0.6, 0, 0.8, 0, out);
    const third = Math.hypot(0.3, 0.9) / 3;
    const expected = [0, 0, third, 0.3 - 0.6 * third, 0, 0.9 - 0.8 * third, 0.3, 0, 0.9];
    for (const [k, x] of expected.entries()) expect(out[k]).toBeCloseTo(x, 9);
  });

  it('keeps its handles between a tenth and eight tenths of the length whatever the points', () => {
    for (let seed = 1; seed < 60; seed++) {
      const points = Float64Array.from({ length: 18 }, (_, i) =>
        i < 3 ? 0 : Math.sin(seed * 12.9898 * (i + 1)) * 1.5,
      );
      const { out } = fitted(points, 0);
      let length = 0;
      for (let i = 3; i < 18; i += 3) length += Math.hypot(...[0, 1, 2].map((k) => points[i + k] - points[i + k - 3]));
      const end = Math.hypot(out[6] - out[3], out[7] - out[4], out[8] - out[5]);
      for (const handle of [out[2], end]) {
        expect(handle).toBeGreaterThan(0.0999 * length);
        expect(handle).toBeLessThan(0.8001 * length);
      }
    }
  });
});
