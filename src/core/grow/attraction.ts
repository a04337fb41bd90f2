import { atan2, sinCos, trig } from './elementary.ts';
import type { Frame } from './frame.ts';
import { turnAboutHorizontal, turnX } from './frame.ts';

/** The angle between the frame's z axis and the tree's, 0..pi; exact near the vertical, where acos is not. */
export const declinationOf = (f: Frame): number => atan2(Math.sqrt(f[6] * f[6] + f[7] * f[7]), f[8]);

/** A vertical stem counts as leaning by this much, so that a drooping tree can begin to droop (row 39). */
const LEAST_DECLINATION = 1e-3;

/** The printed curve_up in radians: AttractionUp declination y_z / segments (Weber & Penn 1995, 4.8; row 38). */
export const curveUp = (f: Frame, attraction: number, segments: number): number =>
  (attraction * declinationOf(f) * f[5]) / segments;

/** The printed form of the attraction: about the stem's own x axis, upwards (erratum E52 of equations.md: the sign). */
export function attractAsPrinted(f: Frame, attraction: number, segments: number): void {
  turnX(f, -curveUp(f, attraction, segments));
}

/**
 * Turns a stem towards the vertical by attraction * declination / segments, about the horizontal axis perpendicular to it (row 38).
 *
 * Growing gives the number of segments that are left, this one included: an attraction of 1 then ends upright from any start. A stem that
 * droops stops where it hangs straight down, and one that is pulled up harder than it can turn swings to the other side by no more than
 * it came from, so a strong pull snakes, as the paper says, and does not spin. `azimuth` in radians is the
 * axis that an exactly vertical stem turns about.
 */
export function attractUp(f: Frame, attraction: number, segments: number, azimuth: number): void {
  const zx = f[6];
  const zy = f[7];
  const horizontal = Math.sqrt(zx * zx + zy * zy);
  const declination = atan2(horizontal, f[8]);
  let angle = (attraction * Math.max(declination, LEAST_DECLINATION)) / segments;
  angle = Math.min(angle, 2 * declination);
  angle = Math.max(angle, declination - Math.PI);
  if (angle === 0) return;
  if (horizontal > 1e-9) {
    turnAboutHorizontal(f, zy / horizontal, -zx / horizontal, angle);
  } else {
    sinCos(azimuth);
    turnAboutHorizontal(f, trig.cos, trig.sin, angle);
  }
}
