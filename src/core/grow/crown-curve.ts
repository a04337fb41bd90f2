/**
 * The length, 0..1, that a crown curve gives at a height of the crown: 0 its base, 1 the top of the tree; clamped to that.
 *
 * `curve`: 2 numbers or more at even steps from the base to the top. Between them runs the cubic of Steffen 1990 ("A simple method for
 * monotonic interpolation in one dimension", Astronomy and Astrophysics 239): through every number, and never beyond its neighbours.
 * Only +, -, * and / : the same on every machine.
 */
export function crownCurve(curve: readonly number[], height: number): number {
  const last = curve.length - 1;
  const at = Math.min(Math.max(height, 0), 1) * last;
  const i = Math.min(Math.floor(at), last - 1);
  const t = at - i;
  const from = curve[i] as number;
  const rise = (curve[i + 1] as number) - from;
  const a = slopeAt(curve, i);
  const b = slopeAt(curve, i + 1);
  // Hermite's cubic, which rounding may take a hair out of the range that its ends span.
  const y = from + t * (a + t * (3 * rise - 2 * a - b + t * (a + b - 2 * rise)));
  return Math.min(Math.max(y, 0), 1);
}

/** The slope at number i of a curve, in units of a step. */
function slopeAt(curve: readonly number[], i: number): number {
  const last = curve.length - 1;
  const secant = (k: number): number => (curve[k + 1] as number) - (curve[k] as number);
  if (last === 1) return secant(0);
  if (i === 0) return endSlope(secant(0), secant(1));
  if (i === last) return endSlope(secant(last - 1), secant(last - 2));
  const before = secant(i - 1);
  const after = secant(i);
  const steepest = Math.min(Math.abs(before), Math.abs(after), Math.abs(before + after) / 4);
  return (Math.sign(before) + Math.sign(after)) * steepest;
}

/** The slope at an end, from the secant there and the next one: that of the parabola, as far as it stays monotone. */
function endSlope(own: number, next: number): number {
  const slope = 1.5 * own - 0.5 * next;
  if (slope * own <= 0) return 0;
  return Math.abs(slope) > 2 * Math.abs(own) ? 2 * own : slope;
}
