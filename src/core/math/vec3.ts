/** A vector or a point in three dimensions. Reference code returns new vectors; hot loops write numbers out. */
export type Vec3 = [number, number, number];

/** Three column vectors; `m[0]` is the image of the x axis. */
export type Mat3 = [Vec3, Vec3, Vec3];

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
/** a + s b. */
export const addScaled = (a: Vec3, b: Vec3, s: number): Vec3 => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vec3): number => Math.sqrt(dot(a, a));
export const distance = (a: Vec3, b: Vec3): number => length(subtract(a, b));
/** (1 - f) a + f b, the form that GLSL's mix computes. */
export const mix = (a: Vec3, b: Vec3, f: number): Vec3 => [
  a[0] * (1 - f) + b[0] * f,
  a[1] * (1 - f) + b[1] * f,
  a[2] * (1 - f) + b[2] * f,
];
/** The vector of length 1 along `a`, or `fallback` where `a` is shorter than 1e-12. */
export function unit(a: Vec3, fallback: Vec3 = [0, 0, 1]): Vec3 {
  const n = length(a);
  return n < 1e-12 ? [fallback[0], fallback[1], fallback[2]] : [a[0] / n, a[1] / n, a[2] / n];
}
/** m a, the sum of the columns of `m` weighted by `a`. */
export const transform = (m: Mat3, a: Vec3): Vec3 => [
  m[0][0] * a[0] + m[1][0] * a[1] + m[2][0] * a[2],
  m[0][1] * a[0] + m[1][1] * a[1] + m[2][1] * a[2],
  m[0][2] * a[0] + m[1][2] * a[1] + m[2][2] * a[2],
];
/** The transpose of `m` times `a`: for a rotation, its inverse applied. */
export const transformTransposed = (m: Mat3, a: Vec3): Vec3 => [dot(m[0], a), dot(m[1], a), dot(m[2], a)];
/** The matrix product a b. */
export const multiply = (a: Mat3, b: Mat3): Mat3 => [transform(a, b[0]), transform(a, b[1]), transform(a, b[2])];
