import { describe, expect, test } from 'vitest';
import {
  fromHemiOctahedral,
  hemiOctahedral,
  nearestViews,
  viewDirection,
  viewFrame,
} from '../../../src/core/forest/octahedral.ts';
import { cross, dot, length, type Vec3 } from '../../../src/core/math/vec3.ts';

/** Directions all over the upper half. */
const directions: Vec3[] = Array.from({ length: 400 }, (_, i) => {
  const z = (i + 0.5) / 400;
  const turn = i * 2.399963;
  const level = Math.sqrt(1 - z * z);
  return [level * Math.cos(turn), level * Math.sin(turn), z];
});

describe('hemi-octahedral square', () => {
  test('there and back is where it was, within the square', () => {
    for (const d of directions) {
      const [a, b] = hemiOctahedral(d);
      expect(Math.max(Math.abs(a), Math.abs(b))).toBeLessThanOrEqual(1 + 1e-12);
      expect(dot(fromHemiOctahedral(a, b), d)).toBeGreaterThan(1 - 1e-12);
    }
  });

  test('below the horizon stands for its nearest on it', () => {
    const [a, b] = hemiOctahedral([0.6, 0, -0.8]);
    expect(fromHemiOctahedral(a, b)).toEqual([1, 0, 0]);
  });

  test('the rim of the views is the horizon, and frames are those of an upright camera', () => {
    for (let i = 0; i < 8; i++) expect(viewDirection(i, 0, 8)[2]).toBeCloseTo(0, 12);
    for (const d of directions) {
      const { right, up } = viewFrame(d);
      expect(right[2]).toBe(0);
      expect(up[2]).toBeGreaterThan(0);
      expect(length(cross(right, up).map((c, k) => c - d[k]!) as Vec3)).toBeLessThan(1e-12);
    }
  });

  test('the three views around a direction weigh 1 together, and their mean looks along it', () => {
    for (const d of directions) {
      const views = nearestViews(d, 8);
      expect(views.reduce((sum, { weight }) => sum + weight, 0)).toBeCloseTo(1, 12);
      const mean: Vec3 = [0, 0, 0];
      for (const { i, j, weight } of views) {
        expect(weight).toBeGreaterThanOrEqual(-1e-12);
        viewDirection(i, j, 8).forEach((c, k) => {
          mean[k]! += weight * c;
        });
      }
      expect(dot(mean, d) / length(mean)).toBeGreaterThan(Math.cos(0.2));
    }
  });

  test('weights do not jump where a direction passes from one cell to the next', () => {
    const pictureOf = (d: Vec3): Map<number, number> =>
      new Map(nearestViews(d, 8).map(({ i, j, weight }) => [8 * i + j, weight]));
    for (let k = 0; k < 3000; k++) {
      const at = (t: number): Vec3 => fromHemiOctahedral(Math.cos(t * 0.37), Math.sin(t * 0.53));
      const [a, b] = [pictureOf(at(k * 0.002)), pictureOf(at(k * 0.002 + 1e-5))];
      for (const view of new Set([...a.keys(), ...b.keys()])) {
        expect(Math.abs((a.get(view) ?? 0) - (b.get(view) ?? 0))).toBeLessThan(2e-4);
      }
    }
  });
});
