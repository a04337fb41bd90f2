/**
 * Sine, cosine, arc tangent, logarithm and power from + - * / and square roots alone.
 *
 * Engines may differ in the last bit of Math.sin and its like; growing must not, or the same seed would be another tree in
 * another browser. All are within 1e-15 of the true value, relative or (sine and cosine) absolute.
 */

const HALF_PI = 1.5707963267948966;
/** Pi/2 in two parts: the first has 33 bits, so its product with a small integer is exact (Cody & Waite). */
const HALF_PI_HIGH = 1.5707963267341256;
const HALF_PI_LOW = 6.077100506506192e-11;
const LN_2 = Math.LN2;
/** Coefficients of the series of sine and cosine: +-1/n!. */
const S11 = -1 / 39916800;
const S13 = 1 / 6227020800;
const S15 = -1 / 1307674368000;
const C10 = -1 / 3628800;
const C12 = 1 / 479001600;
const C14 = -1 / 87178291200;
const C16 = 1 / 20922789888000;

/** The sine and the cosine of the last angle given to `sinCos`. */
export const trig = { sin: 0, cos: 1 };

/** Sine and cosine of an angle in radians, |angle| < 1e5, into `trig`: no allocation in loops over leaves. */
export function sinCos(angle: number): void {
  const k = Math.floor(angle * (1 / HALF_PI) + 0.5);
  const r = angle - k * HALF_PI_HIGH - k * HALF_PI_LOW;
  const q = r * r;
  // Taylor series: the terms left out are below 1e-16 within pi/4.
  const s =
    r * (1 + q * (-1 / 6 + q * (1 / 120 + q * (-1 / 5040 + q * (1 / 362880 + q * (S11 + q * (S13 + q * S15)))))));
  const c =
    1 + q * (-1 / 2 + q * (1 / 24 + q * (-1 / 720 + q * (1 / 40320 + q * (C10 + q * (C12 + q * (C14 + q * C16)))))));
  const quarter = k & 3;
  if (quarter === 0) {
    trig.sin = s;
    trig.cos = c;
  } else if (quarter === 1) {
    trig.sin = c;
    trig.cos = -s;
  } else if (quarter === 2) {
    trig.sin = -s;
    trig.cos = -c;
  } else {
    trig.sin = -c;
    trig.cos = s;
  }
}

/** The arc tangent of t in 0..1: its angle is taken from the nearest of 0, pi/8 and pi/4, the rest is a short series. */
function arcTangent(t: number): number {
  let base = 0;
  let u = t;
  if (t > 0.6681786379192989) {
    base = HALF_PI / 2;
    u = (t - 1) / (t + 1);
  } else if (t > 0.198912367379658) {
    base = HALF_PI / 4;
    u = (t - 0.41421356237309503) / (1 + t * 0.41421356237309503);
  }
  const q = u * u;
  const series = 1 / 11 + q * (-1 / 13 + q * (1 / 15 + q * (-1 / 17 + q * (1 / 19 + q * (-1 / 21)))));
  return base + u * (1 + q * (-1 / 3 + q * (1 / 5 + q * (-1 / 7 + q * (1 / 9 - q * series)))));
}

/** The angle of (x, y) in radians, -pi..pi; 0 for the origin. */
export function atan2(y: number, x: number): number {
  const ax = Math.abs(x);
  const ay = Math.abs(y);
  if (ax === 0 && ay === 0) return 0;
  let angle = ax >= ay ? arcTangent(ay / ax) : HALF_PI - arcTangent(ax / ay);
  if (x < 0) angle = 2 * HALF_PI - angle;
  return y < 0 ? -angle : angle;
}

function logarithm(x: number): number {
  let m = x;
  let e = 0;
  while (m > Math.SQRT2) {
    m *= 0.5;
    e++;
  }
  while (m < Math.SQRT1_2) {
    m *= 2;
    e--;
  }
  const s = (m - 1) / (m + 1);
  const q = s * s;
  let sum = 0;
  for (let n = 21; n >= 1; n -= 2) sum = sum * q + 1 / n;
  return 2 * s * sum + e * LN_2;
}

function exponential(x: number): number {
  if (x < -700) return 0;
  let k = Math.floor(x / LN_2 + 0.5);
  const r = x - k * LN_2;
  let sum = 1;
  for (let n = 14; n >= 1; n--) sum = 1 + (sum * r) / n;
  for (; k > 0; k--) sum *= 2;
  for (; k < 0; k++) sum *= 0.5;
  return sum;
}

/** x^k for 0 <= x <= 1e300 and k >= 0; 0^0 is 1. */
export function power(x: number, k: number): number {
  if (k === 0 || x === 1) return 1;
  if (k === 1) return x;
  return x > 0 ? exponential(k * logarithm(x)) : 0;
}
