import type { Frame } from '../../core/grow/frame.ts';
import type { EnvelopeShape } from '../../core/grow/stem-shape.ts';

/** Turns of the segments where whole segments go to one half or the other, the middle one of an odd number to the first (4.1). */
export const printedDeltas = (curve: number, back: number, n: number): number[] =>
  Array.from({ length: n }, (_, i) => (back === 0 ? curve / n : (i < n / 2 ? curve : back) / (n / 2)));

/** ShapeRatio(8) with the denominator of its lower branch as it is printed in 4.6. */
export const printedEnvelope = (ratio: number, { widthPeak, powerLow, powerHigh }: EnvelopeShape): number => {
  if (ratio < 0 || ratio > 1) return 0;
  return ratio < 1 - widthPeak
    ? (ratio / (1 - widthPeak)) ** powerHigh
    : ((1 - ratio) / Math.max(1e-9, 1 - widthPeak)) ** powerLow;
};

/** Down angle in degrees where the sign of a negative nDownAngleV is lost (4.3). */
export const printedDown = (down: number, downV: number, shape: number): number =>
  down + Math.abs(downV) * (1 - 2 * shape);

/** Turns a frame about one of the tree's axes, 0 = x or 2 = z, by an angle in radians. */
function turnTree(f: Frame, axis: 0 | 2, angle: number): void {
  const [a, b] = axis === 0 ? [1, 2] : [0, 1];
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  for (let i = 0; i < 9; i += 3) {
    const [p, q] = [f[i + a]!, f[i + b]!];
    f[i + a] = cos * p - sin * q;
    f[i + b] = sin * p + cos * q;
  }
}

/**
 * The bend of a leaf towards the light with the last of its turns about x, as 4.9 prints it: that undoes nothing, and the leaf is thrown about.
 * `x`, `y`: where the leaf is.
 */
export function printedLeafBend(f: Frame, x: number, y: number, bend: number): void {
  turnTree(f, 2, bend * (Math.atan2(y, x) - Math.atan2(f[4]!, f[3]!)));
  const phi = Math.atan2(Math.hypot(f[3]!, f[4]!), f[5]!);
  const orientation = Math.acos(Math.min(1, Math.max(-1, f[4]!)));
  turnTree(f, 2, -orientation);
  turnTree(f, 0, bend * phi);
  turnTree(f, 0, orientation);
}
