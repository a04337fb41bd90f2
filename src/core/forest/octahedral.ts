import type { Vec3 } from '../math/vec3.ts';

/**
 * Where a direction of the upper half lies on the hemi-octahedral square -1..1; unit vector, z up; below the horizon its nearest there.
 *
 * The horizon is the rim of the square and the zenith its middle, and neighbours on it are neighbours in the sky. Twin:
 * shaders/forest/octahedral.glsl. Source: the octahedral map of Engelhardt & Dachsbacher 2008, upper half, turned by 45 degrees.
 */
export function hemiOctahedral([x, y, z]: Vec3): [number, number] {
  const n = Math.abs(x) + Math.abs(y) + Math.max(z, 0);
  return [(x + y) / n, (y - x) / n];
}

/** The unit vector of a place on the square; the way back of `hemiOctahedral`. */
export function fromHemiOctahedral(a: number, b: number): Vec3 {
  const x = 0.5 * (a - b);
  const y = 0.5 * (a + b);
  const z = 1 - Math.abs(x) - Math.abs(y);
  const n = Math.sqrt(x * x + y * y + z * z);
  return [x / n, y / n, z / n];
}

/** Direction, from the tree, that view (i, j) of `views` by `views` is taken from: the outermost stand on the horizon. */
export const viewDirection = (i: number, j: number, views: number): Vec3 =>
  fromHemiOctahedral((2 * i) / (views - 1) - 1, (2 * j) / (views - 1) - 1);

/** What a camera that looks from direction d at the tree has to its right and above: unit vectors, d up to the zenith. */
export function viewFrame([x, y, z]: Vec3): { right: Vec3; up: Vec3 } {
  const level = Math.sqrt(x * x + y * y);
  const right: Vec3 = level > 1e-4 ? [-y / level, x / level, 0] : [0, 1, 0];
  return { right, up: [-z * right[1], z * right[0], x * right[1] - y * right[0]] };
}

/** A view and how much of the picture it is. */
export interface WeighedView {
  readonly i: number;
  readonly j: number;
  readonly weight: number;
}

/** The three views around direction d and their weights, which sum to 1 and change without a jump as d does. */
export function nearestViews(d: Vec3, views: number): [WeighedView, WeighedView, WeighedView] {
  const [a, b] = hemiOctahedral(d);
  const last = views - 2;
  const x = (0.5 * a + 0.5) * (views - 1);
  const y = (0.5 * b + 0.5) * (views - 1);
  const i = Math.min(last, Math.max(0, Math.floor(x)));
  const j = Math.min(last, Math.max(0, Math.floor(y)));
  const [fx, fy] = [x - i, y - j];
  const aside = fx > fy ? { i: i + 1, j } : { i, j: j + 1 };
  return [
    { i, j, weight: 1 - Math.max(fx, fy) },
    { ...aside, weight: Math.abs(fx - fy) },
    { i: i + 1, j: j + 1, weight: Math.min(fx, fy) },
  ];
}
