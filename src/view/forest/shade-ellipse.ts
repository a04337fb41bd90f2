import { type HeightField, heightAt } from '../../core/forest/height-field.ts';

/** The crown of a tree as light sees it: an upright ellipsoid, metres in forest space. */
export interface Crown {
  readonly x: number;
  readonly y: number;
  /** Of its middle. */
  readonly z: number;
  readonly wide: number;
  readonly high: number;
}

/** A shadow on the ground from above: middle, half the long axis, half the short one. */
export interface Ellipse {
  x: number;
  y: number;
  alongX: number;
  alongY: number;
  across: number;
}

/** Steps of the way from crown to ground, and the longest of it in crown heights above the ground. */
const STEPS = 10;
const LONGEST = 6;

/**
 * Where the shadow of a crown lies on the ground, written to `out`. `sun`: unit vector to the light, z up.
 *
 * The ray through the crown's middle goes down in steps that shrink towards the hit; a hill in its way is met where it stands.
 */
export function shadeEllipse(
  field: HeightField,
  crown: Crown,
  sun: readonly [number, number, number],
  out: Ellipse,
): void {
  const { x, y, z, wide, high } = crown;
  const [sx, sy, sz] = sun;
  const level = Math.hypot(sx, sy);
  const steep = Math.max(sz, level / LONGEST);
  const slope = level / steep;
  const wayX = level > 1e-6 ? -sx / level : 1;
  const wayY = level > 1e-6 ? -sy / level : 0;
  const flat = Math.max(0, z - heightAt(field, x, y)) * slope;
  let from = 0;
  let to = LONGEST * Math.max(flat, 1e-3) + 1e-3;
  const below = (t: number): boolean => z - t / Math.max(slope, 1e-6) < heightAt(field, x + wayX * t, y + wayY * t);
  // The first step that is below the ground bounds the hit from above.
  for (let i = 1; i <= STEPS; i++) {
    const t = flat * ((2 * i) / STEPS);
    if (below(t)) {
      to = t;
      break;
    }
    from = t;
  }
  for (let i = 0; i < 5; i++) {
    const t = 0.5 * (from + to);
    if (below(t)) to = t;
    else from = t;
  }
  const long = Math.hypot(wide, high * slope);
  out.x = x + wayX * to;
  out.y = y + wayY * to;
  out.alongX = wayX * long;
  out.alongY = wayY * long;
  out.across = wide;
}
