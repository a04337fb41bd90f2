/** Rotations and rigid motions in flat arrays of doubles, so that thousands of keys allocate nothing. Quaternions are x, y, z, w. */

type Numbers = Float64Array;

/** out[to..] = conj(a[at..]) b[bt..]: the rotation from a to b, in a's axes. */
export function relativeRotation(a: Numbers, at: number, b: Numbers, bt: number, out: Numbers, to: number): void {
  const [ax, ay, az, aw] = [-a[at]!, -a[at + 1]!, -a[at + 2]!, a[at + 3]!];
  const [bx, by, bz, bw] = [b[bt]!, b[bt + 1]!, b[bt + 2]!, b[bt + 3]!];
  out[to] = aw * bx + ax * bw + ay * bz - az * by;
  out[to + 1] = aw * by - ax * bz + ay * bw + az * bx;
  out[to + 2] = aw * bz + ax * by - ay * bx + az * bw;
  out[to + 3] = aw * bw - ax * bx - ay * by - az * bz;
}

/** out[to..] = a[at..] b[bt..]; `out` may be neither. */
export function productRotation(a: Numbers, at: number, b: Numbers, bt: number, out: Numbers, to: number): void {
  const [ax, ay, az, aw] = [a[at]!, a[at + 1]!, a[at + 2]!, a[at + 3]!];
  const [bx, by, bz, bw] = [b[bt]!, b[bt + 1]!, b[bt + 2]!, b[bt + 3]!];
  out[to] = aw * bx + ax * bw + ay * bz - az * by;
  out[to + 1] = aw * by - ax * bz + ay * bw + az * bx;
  out[to + 2] = aw * bz + ax * by - ay * bx + az * bw;
  out[to + 3] = aw * bw - ax * bx - ay * by - az * bz;
}

/** out[to..] = the vector (x, y, z) turned by q[qt..], or back by it where `sign` is -1. */
export function turned(
  q: Numbers,
  qt: number,
  sign: 1 | -1,
  x: number,
  y: number,
  z: number,
  out: Numbers,
  to: number,
) {
  const [qx, qy, qz, qw] = [sign * q[qt]!, sign * q[qt + 1]!, sign * q[qt + 2]!, q[qt + 3]!];
  const tx = 2 * (qy * z - qz * y);
  const ty = 2 * (qz * x - qx * z);
  const tz = 2 * (qx * y - qy * x);
  out[to] = x + qw * tx + qy * tz - qz * ty;
  out[to + 1] = y + qw * ty + qz * tx - qx * tz;
  out[to + 2] = z + qw * tz + qx * ty - qy * tx;
}

/** out[to..] = the rotation f of the way from a[at..] to b[bt..], at an even speed, the short way, as glTF interpolates. */
export function slerp(a: Numbers, at: number, b: Numbers, bt: number, f: number, out: Numbers, to: number): void {
  let cosine = a[at]! * b[bt]! + a[at + 1]! * b[bt + 1]! + a[at + 2]! * b[bt + 2]! + a[at + 3]! * b[bt + 3]!;
  const sign = cosine < 0 ? -1 : 1;
  cosine *= sign;
  const square = 1 - cosine * cosine;
  let wa = 1 - f;
  let wb = f;
  if (square > 1e-12) {
    const sine = Math.sqrt(square);
    const angle = Math.atan2(sine, cosine);
    wa = Math.sin((1 - f) * angle) / sine;
    wb = Math.sin(f * angle) / sine;
  }
  wb *= sign;
  let n = 0;
  for (let k = 0; k < 4; k++) {
    out[to + k] = wa * a[at + k]! + wb * b[bt + k]!;
    n += out[to + k]! * out[to + k]!;
  }
  n = 1 / Math.sqrt(n);
  for (let k = 0; k < 4; k++) out[to + k] = out[to + k]! * n;
}

/** Angle between two rotations in radians; the sine of its half stands in, which is the same where it is small. */
export function angleBetween(a: Numbers, at: number, b: Numbers, bt: number): number {
  // |a - b| or |a + b|, whichever is less: the chord on the sphere of rotations, half the angle.
  let minus = 0;
  let plus = 0;
  for (let k = 0; k < 4; k++) {
    const [x, y] = [a[at + k]!, b[bt + k]!];
    minus += (x - y) * (x - y);
    plus += (x + y) * (x + y);
  }
  return 2 * Math.sqrt(Math.min(minus, plus));
}
