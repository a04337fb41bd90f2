import { add, dot, length, mix, scale, subtract, type Vec3 } from './vec3.ts';

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
 * bends up to 90 degrees, but 1 % off where edges fold (equations.md 3.4). `arcLength` holds where this does not.
 */
export function bezierArcLength(c: Cubic): number {
  const speed = (u: number): number => length(bezierDerivative(c, u));
  return W0 * speed(0.5) + W1 * (speed(0.5 - A1) + speed(0.5 + A1)) + W2 * (speed(0.5 - A2) + speed(0.5 + A2));
}

const scaledTo = (c: Cubic, arc: number, rest: number): Cubic => {
  const s = arc > 0 ? rest / arc : 1;
  const from = (p: Vec3): Vec3 => add(c.p0, scale(subtract(p, c.p0), s));
  return { p0: c.p0, p1: from(c.p1), p2: from(c.p2), p3: from(c.p3) };
};

/** The curve scaled about P0 to the arc length `rest` by `bezierArcLength`: edge directions stay (equations.md 3.4). */
export const rescaleArc = (c: Cubic, rest: number): Cubic => scaledTo(c, bezierArcLength(c), rest);

/**
 * The 5-point rule on both halves: for each of ten places the weight times 3, and those of the five coefficients of the square of the
 * speed |dC/du|/3, a quartic in Bernstein form.
 */
const ARC_RULE = new Float64Array(
  [0, 0.5].flatMap((half) =>
    [
      [0, W0],
      [-A1, W1],
      [A1, W1],
      [-A2, W2],
      [A2, W2],
    ].flatMap(([x, weight]) => {
      const u = half + 0.5 * (0.5 + x);
      const v = 1 - u;
      // No powers: engines round them differently, and arc lengths at rest must be the same everywhere.
      const [vv, uu] = [v * v, u * u];
      return [1.5 * weight, vv * vv, 4 * vv * v * u, 6 * vv * uu, 4 * v * u * uu, uu * uu];
    }),
  ),
);

/** Arc length of the cubic whose edges have these products: aa = a.a, ab = a.b and so on; as `arcLength`, for loops without vectors. */
export function arcOfProducts(aa: number, ab: number, ac: number, bb: number, bc: number, cc: number): number {
  const middle = (ac + 2 * bb) / 3;
  let sum = 0;
  for (let i = 0; i < ARC_RULE.length; i += 6) {
    const square =
      ARC_RULE[i + 1] * aa +
      ARC_RULE[i + 2] * ab +
      ARC_RULE[i + 3] * middle +
      ARC_RULE[i + 4] * bc +
      ARC_RULE[i + 5] * cc;
    sum += ARC_RULE[i] * Math.sqrt(Math.max(square, 0));
  }
  return sum;
}

/** Root of a quartic in Bernstein form: q and e its coefficients, w and v their weights. Twin: shaders/lib/bezier.glsl. */
export const quarticRoot = (q: readonly number[], e: number, w: readonly number[], v: number): number =>
  Math.sqrt(Math.max(q[0] * w[0] + q[1] * w[1] + q[2] * w[2] + q[3] * w[3] + e * v, 0));

/**
 * Arc length in the unit of the control points by 5-point Gauss-Legendre on both halves, within 1e-4 of it as long as neighbouring edges
 * turn by at most 105 degrees. Source: equations.md 3.4. Twin: shaders/lib/bezier.glsl.
 */
export function arcLength({ p0, p1, p2, p3 }: Cubic): number {
  const a = subtract(p1, p0);
  const b = subtract(p2, p1);
  const c = subtract(p3, p2);
  return arcOfProducts(dot(a, a), dot(a, b), dot(a, c), dot(b, b), dot(b, c), dot(c, c));
}

/** The curve scaled about P0 to the arc length `rest`: edge directions stay (equations.md 3.4). Twin: shaders/lib/bezier.glsl. */
export const holdArc = (c: Cubic, rest: number): Cubic => scaledTo(c, arcLength(c), rest);
