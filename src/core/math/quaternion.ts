import type { Mat3, Vec3 } from './vec3.ts';

/** A unit quaternion (x, y, z, w): a rotation. */
export type Quaternion = [number, number, number, number];

/** v turned by q, as v + 2 q.xyz x (q.xyz x v + q.w v). Twin: shaders/lib/quaternion.glsl. */
export function rotateByQuaternion(q: Quaternion, v: Vec3): Vec3 {
  const [x, y, z, w] = q;
  const tx = y * v[2] - z * v[1] + w * v[0];
  const ty = z * v[0] - x * v[2] + w * v[1];
  const tz = x * v[1] - y * v[0] + w * v[2];
  return [v[0] + 2 * (y * tz - z * ty), v[1] + 2 * (z * tx - x * tz), v[2] + 2 * (x * ty - y * tx)];
}

/** The columns of the rotation q. */
export const matrixFromQuaternion = (q: Quaternion): Mat3 => [
  rotateByQuaternion(q, [1, 0, 0]),
  rotateByQuaternion(q, [0, 1, 0]),
  rotateByQuaternion(q, [0, 0, 1]),
];

/** Writes the quaternion of the rotation whose columns are `m[0..8]` to `out[at..at+3]`, w >= 0 so that equal rotations give equal numbers. */
export function writeQuaternion(m: Float64Array, out: Float64Array | Float32Array, at: number): void {
  const a = m[0];
  const e = m[4];
  const i = m[8];
  let x: number;
  let y: number;
  let z: number;
  let w: number;
  if (a + e + i > 0) {
    w = 1 + a + e + i;
    x = m[5] - m[7];
    y = m[6] - m[2];
    z = m[1] - m[3];
  } else if (a >= e && a >= i) {
    x = 1 + a - e - i;
    y = m[3] + m[1];
    z = m[6] + m[2];
    w = m[5] - m[7];
  } else if (e >= i) {
    x = m[3] + m[1];
    y = 1 + e - i - a;
    z = m[7] + m[5];
    w = m[6] - m[2];
  } else {
    x = m[6] + m[2];
    y = m[7] + m[5];
    z = 1 + i - a - e;
    w = m[1] - m[3];
  }
  const n = (w < 0 ? -1 : 1) / Math.sqrt(x * x + y * y + z * z + w * w);
  out[at] = x * n;
  out[at + 1] = y * n;
  out[at + 2] = z * n;
  out[at + 3] = w * n;
}
