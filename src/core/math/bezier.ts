import { add, length, mix, scale, subtract, type Vec3 } from './vec3.ts';

/** The four control points of a cubic Bezier curve. */
export interface Cubic {
  p0: Vec3;
  p1: Vec3;
  p2: Vec3;
  p3: Vec3;
}

/** (1-u)^2 a + 2u(1-u) b + u^2 c by de Casteljau's steps. Twin: shaders/lib/bezier.glsl. */
export const quadraticBlend = (a: Vec3, b: Vec3, c: Vec3, u: number): Vec3 => mix(mix(a, b, u), mix(b, c, u), u);

/** The point of the curve at u in 0..1. Twin: shaders/lib/bezier.glsl. */
export const bezierPoint = ({ p0, p1, p2, p3 }: Cubic, u: number): Vec3 =>
  mix(quadraticBlend(p0, p1, p2, u), quadraticBlend(p1, p2, p3, u), u);

/** dC/du: three times the blend of the edges. Twin: shaders/lib/bezier.glsl. */
export const bezierDerivative = ({ p0, p1, p2, p3 }: Cubic, u: number): Vec3 =>
  scale(quadraticBlend(subtract(p1, p0), subtract(p2, p1), subtract(p3, p2), u), 3);

/** d2C/du2. Twin: shaders/lib/bezier.glsl. */
export const bezierSecondDerivative = ({ p0, p1, p2, p3 }: Cubic, u: number): Vec3 =>
  scale(mix(secondDifference(p0, p1, p2), secondDifference(p1, p2, p3), u), 6);

const secondDifference = (a: Vec3, b: Vec3, c: Vec3): Vec3 => subtract(subtract(c, b), subtract(b, a));

/** Abscissae on 0..1 and weights of the 5-point Gauss-Legendre rule: the middle, then the two pairs. */
const A1 = 0.5 * 0.5384693101056831;
const A2 = 0.5 * 0.906179845938664;
const W0 = 0.5 * 0.5688888888888889;
const W1 = 0.5 * 0.47862867049936647;
const W2 = 0.5 * 0.23692688505618908;

/**
 * Arc length in the unit of the control points, by 5-point Gauss-Legendre: within 4e-5 of the length for equal edges and
 * bends up to 90 degrees (equations.md 3.4). Twin: shaders/lib/bezier.glsl.
 */
export function bezierArcLength(c: Cubic): number {
  const speed = (u: number): number => length(bezierDerivative(c, u));
  return W0 * speed(0.5) + W1 * (speed(0.5 - A1) + speed(0.5 + A1)) + W2 * (speed(0.5 - A2) + speed(0.5 + A2));
}

/** The curve scaled about P0 to the arc length `rest`: edge directions stay (equations.md 3.4). Twin: shaders/lib/bezier.glsl. */
export function rescaleArc(c: Cubic, rest: number): Cubic {
  const arc = bezierArcLength(c);
  const s = arc > 0 ? rest / arc : 1;
  const from = (p: Vec3): Vec3 => add(c.p0, scale(subtract(p, c.p0), s));
  return { p0: c.p0, p1: from(c.p1), p2: from(c.p2), p3: from(c.p3) };
}
