import { bezierDerivative, type Cubic, quadraticBlend } from './bezier.ts';
import { add, addScaled, cross, dot, length, type Mat3, scale, subtract, unit, type Vec3 } from './vec3.ts';

/** Unit vectors along the three control edges, and one across each: S_i = L_i x T_i completes the handles of Skjermo 2006. */
export interface Handles {
  l0: Vec3;
  l1: Vec3;
  l2: Vec3;
  t0: Vec3;
  t1: Vec3;
  t2: Vec3;
}

/** Edges shorter than this part of the control polygon have no direction of their own. */
const NO_EDGE = 1e-6;

/** The world axis with the smallest part along the unit vector `l`. Twin: shaders/lib/frames.glsl. */
export function leastAxis(l: Vec3): Vec3 {
  const [x, y, z] = [Math.abs(l[0]), Math.abs(l[1]), Math.abs(l[2])];
  if (x <= y && x <= z) return [1, 0, 0];
  return y <= z ? [0, 1, 0] : [0, 0, 1];
}

/**
 * The unit vector at right angles to the unit vector `l` that is nearest to `a`; where `a` lies along `l` (within 1e-3
 * of its length) or vanishes, the one nearest to the world axis with the smallest part along `l`. Twin: shaders/lib/frames.glsl.
 */
export function across(l: Vec3, a: Vec3): Vec3 {
  const d = addScaled(a, l, -dot(l, a));
  if (dot(d, d) > 1e-6 * dot(a, a) + 1e-30) return scale(d, 1 / length(d));
  const b = leastAxis(l);
  return unit(addScaled(b, l, -dot(l, b)));
}

/**
 * `a`, at right angles to the unit vector p, carried along the shortest rotation from p to the unit vector q; unit and at
 * right angles to q. Where q is -p within 1e-4 there is no shortest rotation: `a` is projected instead.
 * Source: equations.md section 2 (parallel transport instead of equation 8's projection). Twin: shaders/lib/frames.glsl.
 */
export function transport(a: Vec3, p: Vec3, q: Vec3): Vec3 {
  const k = cross(p, q);
  const c = 1 + dot(p, q);
  if (c < 1e-4) return across(q, a);
  return across(q, add(addScaled(scale(a, c - 1), k, dot(k, a) / c), cross(k, a)));
}

/** Directions of the control edges; an edge without length takes the next that has one. Twin: shaders/lib/frames.glsl. */
export function edgesOf({ p0, p1, p2, p3 }: Cubic): [Vec3, Vec3, Vec3] {
  const a = subtract(p1, p0);
  const b = subtract(p2, p1);
  const c = subtract(p3, p2);
  const tiny = NO_EDGE * (length(a) + length(b) + length(c));
  const last = length(c) > tiny;
  const l2 = last ? unit(c) : unit(length(b) > tiny ? b : a);
  const l1 = length(b) > tiny ? unit(b) : unit(subtract(p2, p0), l2);
  return [length(a) > tiny ? unit(a) : l1, l1, l2];
}

/**
 * The handles of a curve whose orientation vector is `o`, parallel-transported from edge to edge: smooth below 180 degrees
 * a joint. Source: Skjermo 2006, equation 8; equations.md section 2. Twin: shaders/lib/frames.glsl.
 */
export function handlesOf(c: Cubic, o: Vec3): Handles {
  const [l0, l1, l2] = edgesOf(c);
  const t0 = across(l0, o); // equation 8: S0 = L0 x O, T0 = S0 x L0
  const t1 = transport(t0, l0, l1);
  return { l0, l1, l2, t0, t1, t2: transport(t1, l1, l2) };
}

/**
 * The handles as equation 8 prints them, made unit vectors: T_i = S_(i-1) x L_i. They twist by up to 10 degrees at a joint of
 * 45 and flip at 90 (errata E9, E12): for teaching. Source: Skjermo 2006, equation 8. Twin: shaders/lib/frames.glsl.
 */
export function projectedHandlesOf(c: Cubic, o: Vec3): Handles {
  const [l0, l1, l2] = edgesOf(c);
  const t0 = across(l0, o);
  const t1 = across(l1, cross(cross(l0, t0), l1));
  return { l0, l1, l2, t0, t1, t2: across(l2, cross(cross(l1, t1), l2)) };
}

/**
 * The frame of the cross-section at u: columns U (along the curve), T^ and S^ = U x T^, orthonormal. The tangent vanishes
 * where control points coincide: the chord stands in. Source: equations.md 3.2. Twin: shaders/lib/frames.glsl.
 */
export function sectionFrame(c: Cubic, h: Handles, u: number): Mat3 {
  const along = tangentAt(c, h, u);
  const t = across(along, quadraticBlend(h.t0, h.t1, h.t2, u));
  return [along, t, cross(along, t)];
}

/** The unit tangent at u; where the derivative vanishes, the chord's direction, or L0 of a point. Twin: shaders/lib/frames.glsl. */
export function tangentAt(c: Cubic, h: Handles, u: number): Vec3 {
  const d = bezierDerivative(c, u);
  const chord = subtract(c.p3, c.p0);
  return dot(d, d) > 1e-12 * dot(chord, chord) ? unit(d, h.l0) : unit(chord, h.l0);
}
