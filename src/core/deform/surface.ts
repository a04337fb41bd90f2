import { bezierDerivative, bezierPoint, bezierSecondDerivative, type Cubic, quadraticBlend } from '../math/bezier.ts';
import { type Handles, sectionFrame } from '../math/frames.ts';
import { add, addScaled, cross, dot, length, mix, scale, subtract, unit, type Vec3 } from '../math/vec3.ts';

/** A point of the bent surface; where the section is a circle, normal x around = along. Directions are unit vectors. */
export interface SurfacePoint {
  position: Vec3;
  /** Outward. */
  normal: Vec3;
  /** Along growing theta: the direction of the texture's s. */
  around: Vec3;
  /** Along growing u: the direction of the texture's t. */
  along: Vec3;
}

/** Below this part of the speed a section's inner side would fold over; the normal keeps pointing outward there. */
const FOLD = 0.01;

/**
 * The surface at u in 0..1 and the angle whose cosine and sine are given (0 on the side of T, a quarter turn on that of S), with
 * sections that are exact circles. `rho` is the radius in metres, `rhoU` its derivative by u, q = (d rho/d angle)/rho. Finite for
 * rho = 0 and where control points coincide. Source: equations.md 3.2 in place of Skjermo 2006, equation 9, whose sections
 * shrink in bends (erratum E19). Twin: shaders/branch/surface.glsl.
 */
export function surfacePoint(
  c: Cubic,
  h: Handles,
  u: number,
  cosTheta: number,
  sinTheta: number,
  rho: number,
  rhoU: number,
  q: number,
): SurfacePoint {
  const [along, t, s] = sectionFrame(c, h, u);
  const radial = addScaled(scale(s, sinTheta), t, cosTheta);
  const turn = addScaled(scale(s, cosTheta), t, -sinTheta);
  const speed = length(bezierDerivative(c, u));
  const second = bezierSecondDerivative(c, u);
  const g0 = Math.max(speed, 1e-6 * length(subtract(c.p3, c.p0)));
  // dU . radial = (C'' - U (U . C'')) . radial / speed, and U . radial = 0.
  const bend = g0 > 0 ? dot(second, radial) / g0 : 0;
  const g = Math.max(g0 - rho * bend, FOLD * g0);
  const n = addScaled(addScaled(scale(radial, g), along, -rhoU), turn, -g * q);
  return {
    position: addScaled(bezierPoint(c, u), radial, rho),
    normal: unit(n, radial),
    around: unit(addScaled(turn, radial, q), turn),
    along: unit(addScaled(scale(along, g), radial, rhoU), along),
  };
}

/** The paper's mapping of (u, v, w) through the handles, with its partial derivatives; v and w in metres on S and T. */
export interface Deformed {
  position: Vec3;
  byU: Vec3;
  byV: Vec3;
  byW: Vec3;
}

/**
 * Generalised de Casteljau: the point with the coordinates v on S and w on T in the cross-section at u, and its Jacobian.
 * Source: Skjermo 2006, equations 9 and 16 (errata E8, E14 to E17). Twin: shaders/branch/surface.glsl.
 */
export function deform(c: Cubic, h: Handles, u: number, v: number, w: number): Deformed {
  const [s0, s1, s2] = [cross(h.l0, h.t0), cross(h.l1, h.t1), cross(h.l2, h.t2)];
  const byV = quadraticBlend(s0, s1, s2, u);
  const byW = quadraticBlend(h.t0, h.t1, h.t2, u);
  const slopeV = scale(mix(subtract(s1, s0), subtract(s2, s1), u), 2);
  const slopeW = scale(mix(subtract(h.t1, h.t0), subtract(h.t2, h.t1), u), 2);
  return {
    position: addScaled(addScaled(bezierPoint(c, u), byV, v), byW, w),
    byU: addScaled(addScaled(bezierDerivative(c, u), slopeV, v), slopeW, w),
    byV,
    byW,
  };
}

/**
 * The surface as the paper makes it: sections of blended handles, which shrink in the plane of a bend. For teaching.
 * Arguments as in `surfacePoint`. Source: Skjermo 2006, equations 9, 13 and 16 (errata E10, E13, E18).
 * Twin: shaders/branch/surface.glsl.
 */
export function paperSurfacePoint(
  c: Cubic,
  h: Handles,
  u: number,
  cosTheta: number,
  sinTheta: number,
  rho: number,
  rhoU: number,
  q: number,
): SurfacePoint {
  const d = deform(c, h, u, rho * sinTheta, rho * cosTheta);
  const radial = addScaled(scale(d.byV, sinTheta), d.byW, cosTheta);
  const along = addScaled(d.byU, radial, rhoU);
  const turn = add(scale(d.byV, cosTheta + q * sinTheta), scale(d.byW, q * cosTheta - sinTheta));
  const n = cross(turn, along);
  const outward = unit(radial, h.t0);
  const around = unit(turn, cross(h.l0, h.t0));
  const normal = dot(n, n) > 1e-18 ? unit(n) : outward;
  return {
    position: d.position,
    normal: dot(normal, radial) < 0 ? scale(normal, -1) : normal,
    around,
    along: unit(along, h.l0),
  };
}
