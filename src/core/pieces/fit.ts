/** What a fit asks for: at most this many reparametrisations (equations.md 7.2: 12 to 20). */
const ITERATIONS = 16;
/** After this many it ends too where the distance is still this many times what is enough: it will not get there. */
const HOPE = 4;
const HOPELESS = 4;
/**
 * Weight of the pull towards handles of a third of the length. It decides what few points leave open, and keeps handles from
 * growing long for the last thousandth of the distance: with 1e-2 the four species need the fewest pieces.
 */
const RIDGE = 1e-2;

/** Result of a fit: P1, P2, P3 relative to P0 (9 numbers), then the largest distance of a point from the curve. */
export type Fitted = Float64Array;
export const FITTED = 10;

let parameters = new Float64Array(64);

/**
 * Fits one cubic Bezier to points `first` to `last` of `points` (3 a point), with both ends and the start tangent
 * (tx, ty, tz) fixed and P1's distance and the whole of P2 free: fit (b) of equations.md 7.2.
 *
 * `ex, ey, ez` is the direction in which the points end, used where they say too little. Ends early when the largest
 * distance falls under `enough`, or is still far above it after a few steps. Writes to `out`; returns the largest distance in the points' unit.
 */
export function fitCubicFree(
  points: Float64Array,
  first: number,
  last: number,
  tx: number,
  ty: number,
  tz: number,
  ex: number,
  ey: number,
  ez: number,
  enough: number,
  out: Fitted,
): number {
  const inner = last - first - 1;
  if (parameters.length < inner) parameters = new Float64Array(2 * inner);
  const s = parameters;
  const ox = points[3 * first];
  const oy = points[3 * first + 1];
  const oz = points[3 * first + 2];
  const p3x = points[3 * last] - ox;
  const p3y = points[3 * last + 1] - oy;
  const p3z = points[3 * last + 2] - oz;
  const length = chordParameters(points, first, last, s);
  // Where the handles rest if nothing else speaks.
  const third = length / 3;
  const dx = p3x - third * ex;
  const dy = p3y - third * ey;
  const dz = p3z - third * ez;
  let worst = 0;
  for (let iteration = 0; ; iteration++) {
    let s11 = RIDGE;
    let s12 = 0;
    let s22 = RIDGE;
    let g = RIDGE * third;
    let hx = RIDGE * dx;
    let hy = RIDGE * dy;
    let hz = RIDGE * dz;
    for (let i = 0; i < inner; i++) {
      const u = s[i];
      const w = 1 - u;
      const b1 = 3 * w * w * u;
      const b2 = 3 * w * u * u;
      const b3 = u * u * u;
      const at = 3 * (first + 1 + i);
      const rx = points[at] - ox - b3 * p3x;
      const ry = points[at + 1] - oy - b3 * p3y;
      const rz = points[at + 2] - oz - b3 * p3z;
      s11 += b1 * b1;
      s12 += b1 * b2;
      s22 += b2 * b2;
      g += b1 * (tx * rx + ty * ry + tz * rz);
      hx += b2 * rx;
      hy += b2 * ry;
      hz += b2 * rz;
    }
    const determinant = s11 - (s12 * s12) / s22;
    let a = (g - (s12 / s22) * (tx * hx + ty * hy + tz * hz)) / determinant;
    a = Math.min(0.8 * length, Math.max(0.1 * length, a));
    let p2x = (hx - a * tx * s12) / s22;
    let p2y = (hy - a * ty * s12) / s22;
    let p2z = (hz - a * tz * s12) / s22;
    // The end handle gives the next piece of a chain its direction: it must not vanish nor run away.
    let qx = p3x - p2x;
    let qy = p3y - p2y;
    let qz = p3z - p2z;
    let q = Math.sqrt(qx * qx + qy * qy + qz * qz);
    if (q < 1e-3 * length) {
      qx = ex;
      qy = ey;
      qz = ez;
      q = 1;
    }
    const b = Math.min(0.8 * length, Math.max(0.1 * length, q));
    if (b !== q) {
      p2x = p3x - (b / q) * qx;
      p2y = p3y - (b / q) * qy;
      p2z = p3z - (b / q) * qz;
    }
    out[0] = a * tx;
    out[1] = a * ty;
    out[2] = a * tz;
    out[3] = p2x;
    out[4] = p2y;
    out[5] = p2z;
    out[6] = p3x;
    out[7] = p3y;
    out[8] = p3z;
    worst = reparametrise(points, first, inner, s, out);
    if (worst <= enough || iteration === ITERATIONS) break;
    if (iteration >= HOPE && worst > HOPELESS * enough) break;
  }
  out[9] = worst;
  return worst;
}

/**
 * Fits one cubic Bezier to all of `points` with both end tangents fixed, unknown handle lengths a and b: fit (a) of
 * equations.md 7.2, for curves whose end direction is known. Same result as `fitCubicFree`.
 */
export function fitCubicTangents(
  points: Float64Array,
  start: readonly number[],
  end: readonly number[],
  iterations: number,
  out: Fitted,
): number {
  const last = points.length / 3 - 1;
  const s = new Float64Array(Math.max(0, last - 1));
  const length = chordParameters(points, 0, last, s);
  const p3 = [0, 1, 2].map((k) => points[3 * last + k] - points[k]);
  const across = start[0] * end[0] + start[1] * end[1] + start[2] * end[2];
  let worst = 0;
  for (let iteration = 0; iteration <= iterations; iteration++) {
    let a11 = 0;
    let a12 = 0;
    let a22 = 0;
    let g1 = 0;
    let g2 = 0;
    for (let i = 0; i < s.length; i++) {
      const u = s[i];
      const w = 1 - u;
      const b1 = 3 * w * w * u;
      const b2 = 3 * w * u * u;
      const ends = b2 + u * u * u;
      a11 += b1 * b1;
      a12 -= across * b1 * b2;
      a22 += b2 * b2;
      for (let k = 0; k < 3; k++) {
        const r = points[3 * (i + 1) + k] - points[k] - ends * p3[k];
        g1 += b1 * start[k] * r;
        g2 -= b2 * end[k] * r;
      }
    }
    const determinant = a11 * a22 - a12 * a12;
    let a = (g1 * a22 - g2 * a12) / determinant;
    let b = (g2 * a11 - g1 * a12) / determinant;
    const outside = (h: number): boolean => !(h >= 0.05 * length && h <= 1.5 * length);
    if (Math.abs(determinant) < 1e-12 || outside(a) || outside(b)) {
      a = length / 3;
      b = length / 3;
    }
    for (let k = 0; k < 3; k++) {
      out[k] = a * start[k];
      out[3 + k] = p3[k] - b * end[k];
      out[6 + k] = p3[k];
    }
    worst = reparametrise(points, 0, s.length, s, out);
  }
  out[9] = worst;
  return worst;
}

/** Writes the share of the polyline's length at each inner point to `s`; returns the whole length. */
function chordParameters(points: Float64Array, first: number, last: number, s: Float64Array): number {
  let length = 0;
  for (let i = first; i < last; i++) {
    const x = points[3 * i + 3] - points[3 * i];
    const y = points[3 * i + 4] - points[3 * i + 1];
    const z = points[3 * i + 5] - points[3 * i + 2];
    length += Math.sqrt(x * x + y * y + z * z);
    if (i + 1 < last) s[i - first] = length;
  }
  for (let i = 0; i < last - first - 1; i++) s[i] /= length;
  return length;
}

/**
 * Largest distance of the inner points from the curve at their parameters; moves each parameter one Newton step towards
 * the nearest place on the curve.
 */
function reparametrise(points: Float64Array, first: number, inner: number, s: Float64Array, c: Fitted): number {
  const ox = points[3 * first];
  const oy = points[3 * first + 1];
  const oz = points[3 * first + 2];
  let worst = 0;
  for (let i = 0; i < inner; i++) {
    const at = 3 * (first + 1 + i);
    const u = s[i];
    const w = 1 - u;
    const b1 = 3 * w * w * u;
    const b2 = 3 * w * u * u;
    const b3 = u * u * u;
    const x = b1 * c[0] + b2 * c[3] + b3 * c[6] - (points[at] - ox);
    const y = b1 * c[1] + b2 * c[4] + b3 * c[7] - (points[at + 1] - oy);
    const z = b1 * c[2] + b2 * c[5] + b3 * c[8] - (points[at + 2] - oz);
    worst = Math.max(worst, x * x + y * y + z * z);
    const d0 = 3 * w * w;
    const d1 = 6 * w * u;
    const d2 = 3 * u * u;
    const ux = d0 * c[0] + d1 * (c[3] - c[0]) + d2 * (c[6] - c[3]);
    const uy = d0 * c[1] + d1 * (c[4] - c[1]) + d2 * (c[7] - c[4]);
    const uz = d0 * c[2] + d1 * (c[5] - c[2]) + d2 * (c[8] - c[5]);
    const e0 = 6 * w;
    const e1 = 6 * u;
    const vx = e0 * (c[3] - 2 * c[0]) + e1 * (c[6] - 2 * c[3] + c[0]);
    const vy = e0 * (c[4] - 2 * c[1]) + e1 * (c[7] - 2 * c[4] + c[1]);
    const vz = e0 * (c[5] - 2 * c[2]) + e1 * (c[8] - 2 * c[5] + c[2]);
    const slope = ux * ux + uy * uy + uz * uz + x * vx + y * vy + z * vz;
    if (slope > 1e-12) s[i] = Math.min(1, Math.max(0, u - (x * ux + y * uy + z * uz) / slope));
  }
  return Math.sqrt(worst);
}
