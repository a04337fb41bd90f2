import { arcOfProducts } from '../math/bezier.ts';
import { writeColumns } from '../math/columns.ts';

/**
 * One piece as 21 numbers in a row, for loops over many pieces: control points P0, P1, P2, P3, then the handles T0, T1, T2
 * (the T of the frame of each control edge). The same formulas as math/bezier.ts and math/frames.ts, without a vector
 * allocated; a test holds them against those twins.
 */
export const RECORD = 21;

/** Gauss-Legendre, 5 points on [0, 1]: places and weights (equations.md 3.4). */
const NODES = [
  0.5,
  0.5 - 0.26923465505284155,
  0.5 + 0.26923465505284155,
  0.5 - 0.453089922969332,
  0.5 + 0.453089922969332,
];
const WEIGHTS = [
  0.2844444444444444, 0.23931433524968326, 0.23931433524968326, 0.11846344252809454, 0.11846344252809454,
];

const speed = (c: Float64Array, at: number, u: number): number => {
  const a = 3 * (1 - u) * (1 - u);
  const b = 6 * (1 - u) * u;
  const d = 3 * u * u;
  const x = a * (c[at + 3] - c[at]) + b * (c[at + 6] - c[at + 3]) + d * (c[at + 9] - c[at + 6]);
  const y = a * (c[at + 4] - c[at + 1]) + b * (c[at + 7] - c[at + 4]) + d * (c[at + 10] - c[at + 7]);
  const z = a * (c[at + 5] - c[at + 2]) + b * (c[at + 8] - c[at + 5]) + d * (c[at + 11] - c[at + 8]);
  return Math.sqrt(x * x + y * y + z * z);
};

/** Arc length in metres from 0 to `u` of the record at `at`. */
export function recordArc(c: Float64Array, at: number, u: number): number {
  let sum = 0;
  for (let j = 0; j < 5; j++) sum += WEIGHTS[j] * speed(c, at, u * NODES[j]);
  return sum * u;
}

/** The whole arc length in metres of the record at `at`: `arcLength`, by which the wind holds it. */
export function recordLength(c: Float64Array, at: number): number {
  const product = (i: number, j: number): number => {
    let sum = 0;
    for (let k = at; k < at + 3; k++) {
      sum += (c[k + 3 * i + 3] - c[k + 3 * i]) * (c[k + 3 * j + 3] - c[k + 3 * j]);
    }
    return sum;
  };
  return arcOfProducts(product(0, 0), product(0, 1), product(0, 2), product(1, 1), product(1, 2), product(2, 2));
}

/** The Bezier parameter at a fraction 0..1 of the arc length `arc`, by Newton's method (equations.md, section 4). */
export function recordParameter(c: Float64Array, at: number, fraction: number, arc: number): number {
  if (!(fraction > 0)) return 0;
  if (fraction >= 1) return 1;
  const target = fraction * arc;
  let v = fraction;
  for (let step = 0; step < 5; step++) {
    const error = recordArc(c, at, v) - target;
    if (Math.abs(error) < 1e-7 * arc) break;
    v = Math.min(1, Math.max(0, v - error / Math.max(speed(c, at, v), 1e-12)));
  }
  return v;
}

/** Writes the point at `u` to `out[0..2]`. */
export function recordPoint(c: Float64Array, at: number, u: number, out: Float64Array): void {
  const w = 1 - u;
  const b0 = w * w * w;
  const b1 = 3 * w * w * u;
  const b2 = 3 * w * u * u;
  const b3 = u * u * u;
  out[0] = b0 * c[at] + b1 * c[at + 3] + b2 * c[at + 6] + b3 * c[at + 9];
  out[1] = b0 * c[at + 1] + b1 * c[at + 4] + b2 * c[at + 7] + b3 * c[at + 10];
  out[2] = b0 * c[at + 2] + b1 * c[at + 5] + b2 * c[at + 8] + b3 * c[at + 11];
}

/**
 * Fills T1 and T2 of a record from its control points and T0 by parallel transport (equations.md, section 2, "rmf"), and
 * makes T0 perpendicular to the first edge.
 */
export function transportRecord(c: Float64Array, at: number): void {
  const t = at + 12;
  let lx = c[at + 3] - c[at];
  let ly = c[at + 4] - c[at + 1];
  let lz = c[at + 5] - c[at + 2];
  let n = 1 / Math.sqrt(lx * lx + ly * ly + lz * lz);
  lx *= n;
  ly *= n;
  lz *= n;
  let tx = c[t];
  let ty = c[t + 1];
  let tz = c[t + 2];
  let along = tx * lx + ty * ly + tz * lz;
  tx -= along * lx;
  ty -= along * ly;
  tz -= along * lz;
  n = 1 / Math.sqrt(tx * tx + ty * ty + tz * tz);
  tx *= n;
  ty *= n;
  tz *= n;
  c[t] = tx;
  c[t + 1] = ty;
  c[t + 2] = tz;
  for (let edge = 1; edge < 3; edge++) {
    const e = at + 3 * edge;
    let mx = c[e + 3] - c[e];
    let my = c[e + 4] - c[e + 1];
    let mz = c[e + 5] - c[e + 2];
    const length = Math.sqrt(mx * mx + my * my + mz * mz);
    if (length > 1e-12) {
      mx /= length;
      my /= length;
      mz /= length;
    } else {
      mx = lx;
      my = ly;
      mz = lz;
    }
    const kx = ly * mz - lz * my;
    const ky = lz * mx - lx * mz;
    const kz = lx * my - ly * mx;
    const cosine = lx * mx + ly * my + lz * mz;
    if (1 + cosine >= 1e-4) {
      const k = (kx * tx + ky * ty + kz * tz) / (1 + cosine);
      const nx = cosine * tx + (ky * tz - kz * ty) + k * kx;
      const ny = cosine * ty + (kz * tx - kx * tz) + k * ky;
      const nz = cosine * tz + (kx * ty - ky * tx) + k * kz;
      tx = nx;
      ty = ny;
      tz = nz;
    }
    along = tx * mx + ty * my + tz * mz;
    tx -= along * mx;
    ty -= along * my;
    tz -= along * mz;
    n = 1 / Math.sqrt(tx * tx + ty * ty + tz * tz);
    tx *= n;
    ty *= n;
    tz *= n;
    c[t + 3 * edge] = tx;
    c[t + 3 * edge + 1] = ty;
    c[t + 3 * edge + 2] = tz;
    lx = mx;
    ly = my;
    lz = mz;
  }
}

/** Writes the section frame at `u`, columns U, T^, S^, to `out[0..8]` (equations.md 3.2). */
export function recordFrame(c: Float64Array, at: number, u: number, out: Float64Array): void {
  const w = 1 - u;
  const a0 = w * w;
  const a1 = 2 * w * u;
  const a2 = u * u;
  let x = a0 * (c[at + 3] - c[at]) + a1 * (c[at + 6] - c[at + 3]) + a2 * (c[at + 9] - c[at + 6]);
  let y = a0 * (c[at + 4] - c[at + 1]) + a1 * (c[at + 7] - c[at + 4]) + a2 * (c[at + 10] - c[at + 7]);
  let z = a0 * (c[at + 5] - c[at + 2]) + a1 * (c[at + 8] - c[at + 5]) + a2 * (c[at + 11] - c[at + 8]);
  let n = Math.sqrt(x * x + y * y + z * z);
  if (n < 3e-10) {
    x = c[at + 9] - c[at];
    y = c[at + 10] - c[at + 1];
    z = c[at + 11] - c[at + 2];
    n = Math.sqrt(x * x + y * y + z * z);
  }
  x /= n;
  y /= n;
  z /= n;
  const t = at + 12;
  let tx = a0 * c[t] + a1 * c[t + 3] + a2 * c[t + 6];
  let ty = a0 * c[t + 1] + a1 * c[t + 4] + a2 * c[t + 7];
  let tz = a0 * c[t + 2] + a1 * c[t + 5] + a2 * c[t + 8];
  const along = tx * x + ty * y + tz * z;
  tx -= along * x;
  ty -= along * y;
  tz -= along * z;
  n = 1 / Math.sqrt(tx * tx + ty * ty + tz * tz);
  tx *= n;
  ty *= n;
  tz *= n;
  writeColumns(out, x, y, z, tx, ty, tz);
}
