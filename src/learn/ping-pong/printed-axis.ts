import { type Cubic, quadraticBlend } from '../../core/math/bezier.ts';
import { type Handles, handlesOf, sectionFrame } from '../../core/math/frames.ts';
import { add, cross, dot, scale, unit, type Vec3 } from '../../core/math/vec3.ts';

/** S_i = L_i x T_i, blended: the second axis of the bent section. */
const blendS = (h: Handles, u: number): Vec3 =>
  quadraticBlend(cross(h.l0, h.t0), cross(h.l1, h.t1), cross(h.l2, h.t2), u);

/**
 * V as the paper constructs it: from the curve to the bent surface at theta, made a unit vector. The section there does not stand at right
 * angles to the curve, so V does not either. Source: Skjermo 2007, 4.2 (erratum E33).
 */
export function printedAxis(parent: Cubic, o: Vec3, v: number, theta: number): Vec3 {
  const h = handlesOf(parent, o);
  return unit(add(scale(quadraticBlend(h.t0, h.t1, h.t2, v), Math.cos(theta)), scale(blendS(h, v), Math.sin(theta))));
}

/** U and V at right angles to each other, as Windgrove has them, and W = U x V. */
export function attachAxes(parent: Cubic, o: Vec3, v: number, theta: number): [u: Vec3, v: Vec3, w: Vec3] {
  const [u, t, s] = sectionFrame(parent, handlesOf(parent, o), v);
  const across = add(scale(t, Math.cos(theta)), scale(s, Math.sin(theta)));
  return [u, across, cross(u, across)];
}

/** How far from a right angle two unit vectors are, degrees: positive where they lean towards each other. */
export const leanOf = (a: Vec3, b: Vec3): number => (Math.asin(Math.min(1, Math.max(-1, dot(a, b)))) * 180) / Math.PI;
