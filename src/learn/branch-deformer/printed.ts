import { deform } from '../../core/deform/surface.ts';
import { bezierPoint, type Cubic, quadraticBlend } from '../../core/math/bezier.ts';
import { across, edgesOf, type Handles } from '../../core/math/frames.ts';
import { add, addScaled, cross, mix, scale, subtract, unit, type Vec3 } from '../../core/math/vec3.ts';

// What the papers print and what does not hold. It lives here, beside the lesson that shows why, and nowhere in the core.

/** Slope of the taper with the sign of equation 10 in print (erratum E1). */
export const printedTaperSlope = (z: number, radius: number, t: number): number => t * radius * z ** (t - 1);

/** Slope of the flare as equation 10 prints it: a difference where a product belongs (erratum E2). */
export const printedFlareSlope = (z: number, f: number): number => f / 100 - 8 * Math.log(100) * 100 ** (1 - 8 * z);

/** Derivative of the lobes by the angle (in radians) as equation 11 prints it: its second term lost the depth (erratum E3). */
export const printedLobesByAngle = (z: number, angle: number, n: number, depth: number, fade: number): number =>
  depth * n * Math.cos(n * angle) - n * fade * Math.cos(n * angle) * z;

/** The length of the handles T1 and T2 that equation 8 leaves as they come out of the cross products, T0 = 1 (erratum E9). */
export function printedHandleLengths(c: Cubic, o: Vec3): [t0: number, t1: number, t2: number] {
  const [l0, l1, l2] = edgesOf(c);
  const s0 = cross(l0, o);
  const t1 = cross(s0, l1);
  const t2 = cross(cross(l1, t1), l2);
  return [Math.hypot(...cross(s0, l0)), Math.hypot(...t1), Math.hypot(...t2)];
}

/** Handles that all lean on one fixed direction, as one writes them first: they flip where the curve passes it. */
export function fixedUpHandles(c: Cubic, up: Vec3): Handles {
  const [l0, l1, l2] = edgesOf(c);
  return { l0, l1, l2, t0: across(l0, up), t1: across(l1, up), t2: across(l2, up) };
}

/** Handle S of an edge: L x T. */
export const sidesOf = (h: Handles): [Vec3, Vec3, Vec3] => [cross(h.l0, h.t0), cross(h.l1, h.t1), cross(h.l2, h.t2)];

/** The points of the generalised de Casteljau construction, level by level; the last is the deformed point. */
export interface Construction {
  readonly edges: readonly [Vec3, Vec3, Vec3];
  readonly pair: readonly [Vec3, Vec3];
  readonly point: Vec3;
}

/**
 * Equation 9 step by step for the point (u, v on S, w on T). `printed`: with its last line as the second paper has it, which blends R10 and R11
 * in place of R01 and R11 (erratum E8).
 */
export function construction(c: Cubic, h: Handles, u: number, v: number, w: number, printed = false): Construction {
  const s = sidesOf(h);
  const t = [h.t0, h.t1, h.t2] as const;
  const p = [c.p0, c.p1, c.p2, c.p3] as const;
  const level = ([0, 1, 2] as const).map((i) =>
    addScaled(addScaled(mix(p[i], p[i + 1] as Vec3, u), s[i], v), t[i], w),
  ) as [Vec3, Vec3, Vec3];
  const pair = [mix(level[0], level[1], u), mix(level[1], level[2], u)] as const;
  return { edges: level, pair, point: printed ? mix(level[1], pair[1], u) : mix(pair[0], pair[1], u) };
}

/** The Jacobian's rows by u and by w as equation 15 prints them (errata E14, E15). */
export function printedJacobian(c: Cubic, h: Handles, u: number, v: number, w: number): { byU: Vec3; byW: Vec3 } {
  const right = deform(c, h, u, v, w);
  // "T2 - 2 T1 T0": a product of vectors has to be read as something; component by component changes least.
  const product: Vec3 = [h.t1[0] * h.t0[0], h.t1[1] * h.t0[1], h.t1[2] * h.t0[2]];
  const meant = add(subtract(h.t2, scale(h.t1, 2)), h.t0);
  const printed = subtract(h.t2, scale(product, 2));
  const s1 = cross(h.l1, h.t1);
  const byW = addScaled(addScaled(h.t0, meant, u * u), subtract(s1, h.t0), 2 * w);
  return { byU: addScaled(right.byU, subtract(printed, meant), 2 * u * w), byW };
}

/** The normal as the paper's last lines give it, T x B: the handles are left-handed in its order, so it points into the wood (erratum E10). */
export function printedNormal(
  c: Cubic,
  h: Handles,
  u: number,
  cosTheta: number,
  sinTheta: number,
  rho: number,
  rhoU: number,
  q: number,
): Vec3 {
  const d = deform(c, h, u, rho * sinTheta, rho * cosTheta);
  const along = addScaled(d.byU, addScaled(scale(d.byV, sinTheta), d.byW, cosTheta), rhoU);
  const turn = add(scale(d.byV, cosTheta + q * sinTheta), scale(d.byW, q * cosTheta - sinTheta));
  return unit(cross(along, turn), d.byW);
}

/** The normal that takes the branch for a cylinder: straight away from its axis. */
export function naiveNormal(h: Handles, u: number, cosTheta: number, sinTheta: number): Vec3 {
  const [s0, s1, s2] = sidesOf(h);
  const s = quadraticBlend(s0, s1, s2, u);
  const t = quadraticBlend(h.t0, h.t1, h.t2, u);
  return unit(addScaled(scale(s, sinTheta), t, cosTheta), h.t0);
}

/** The largest angle by which Sloan's projection twists a frame at a joint of `angle` radians: tan = (1 - cos) / (2 sqrt(cos)). */
export const mostTwist = (angle: number): number => Math.atan((1 - Math.cos(angle)) / (2 * Math.sqrt(Math.cos(angle))));

/** Where the curve ends up that the printed last line of equation 9 begins with: the distance of its first point from P0. */
export const printedGap = (c: Cubic, h: Handles): number =>
  Math.hypot(...subtract(construction(c, h, 0, 0, 0, true).point, bezierPoint(c, 0)));
