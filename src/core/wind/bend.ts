import { power as exactPower } from '../grow/elementary.ts';
import { type Cubic, rescaleArc } from '../math/bezier.ts';
import { angleOfChord, power } from '../math/trig.ts';
import { add, addScaled, distance, length, scale, subtract, type Vec3 } from '../math/vec3.ts';

/** The two weights of a piece: the share of its stem's bend that its second and third edge take. */
export type BendWeights = [w2: number, w3: number];

/**
 * g(s) = s^1.8: how the bend of a stem grows from its base (0) to its tip (1). Source: Skjermo 2007, equation 16.
 * The weights are packed: by a power that is the same on every engine.
 */
export const bendShare = (s: number): number => exactPower(s, 1.8);

/**
 * Bend weights of a piece that covers [z0, z1] of its stem, so that the stem bends the same however many pieces it has; a whole
 * stem has (1/3)^1.8 and 1. Source: Skjermo 2007, equation 16 (erratum E28); equations.md 7.4.
 */
export function bendWeights(z0: number, z1: number): BendWeights {
  const start = bendShare(z0);
  return [bendShare(z0 + (z1 - z0) / 3) - start, bendShare(z1) - start];
}

/**
 * The change of direction that a force (metres, horizontal) gives a stem: G(F)/l^m with G(F) = F |F|^(p-1). `third` is l, a third
 * of the stem's length in metres; the presets have p = 1 and m = 0.6, the paper p = 1.8 and m = 2.
 * Source: Skjermo 2007, equations 14 and 16 (errata E27, E28). Twin: shaders/wind/bend.glsl.
 */
export function bendVector(fx: number, fy: number, third: number, p: number, m: number): Vec3 {
  const strength = Math.sqrt(fx * fx + fy * fy);
  const gain = p === 1 ? 1 : strength > 0 ? power(strength, p - 1) : 0;
  const softness = m === 1 ? 1 / third : m === 0 ? 1 : power(third, -m);
  return [fx * gain * softness, fy * gain * softness, 0];
}

/** A bent curve and the angle in radians by which its last edge turned. */
export interface Bent {
  curve: Cubic;
  angle: number;
}

/** The edge e turned by adding `push` to its direction; its length is kept. Against the edge itself nothing can turn it. */
export function turnEdge(e: Vec3, push: Vec3): Vec3 {
  const l = length(e);
  const d = addScaled(e, push, l);
  const n = length(d);
  return n > 1e-6 * l ? scale(d, l / n) : e;
}

/**
 * Bends a placed piece: its second and third edge turn by w2 and w3 times `beta` and keep their lengths, P0 and P1 stay.
 * Source: Skjermo 2007, equation 17 (errata E29, E30). Twin: shaders/wind/bend.glsl.
 */
export function bendStep(c: Cubic, beta: Vec3, w2: number, w3: number): Bent {
  const e3 = subtract(c.p3, c.p2);
  const f3 = turnEdge(e3, scale(beta, w3));
  const p2 = add(c.p1, turnEdge(subtract(c.p2, c.p1), scale(beta, w2)));
  return { curve: { p0: c.p0, p1: c.p1, p2, p3: add(p2, f3) }, angle: turnAngle(e3, f3) };
}

/**
 * The step as printed, made consistent: the print divides e + b by |e| and so makes every edge 1 m long; times that length
 * it says e + b, and the branch stretches with the wind. For teaching. Source: Skjermo 2007, equation 17 (erratum E29).
 * Twin: shaders/wind/bend.glsl.
 */
export function paperBendStep(c: Cubic, beta: Vec3, w2: number, w3: number): Bent {
  const e2 = subtract(c.p2, c.p1);
  const e3 = subtract(c.p3, c.p2);
  const f3 = addScaled(e3, beta, w3 * length(e3));
  const p2 = add(c.p1, addScaled(e2, beta, w2 * length(e2)));
  return { curve: { p0: c.p0, p1: c.p1, p2, p3: add(p2, f3) }, angle: turnAngle(e3, f3) };
}

/** The angle in radians between two edges, 0 where one has no length. Twin: shaders/wind/bend.glsl. */
export function turnAngle(a: Vec3, b: Vec3): number {
  const [m, n] = [length(a), length(b)];
  return m > 0 && n > 0 ? angleOfChord(distance(scale(a, 1 / m), scale(b, 1 / n))) : 0;
}

/** How the wind's force becomes bend: exponents p and m, and the paper's forms. */
export interface BendModel {
  forceExponent: number;
  lengthExponent: number;
  paper: boolean;
}

/**
 * Bends a placed piece by a force in metres and gives it its arc length at rest back (not in the paper's form).
 * Source: equations.md 3.4 and 5.5. Twin: shaders/wind/bend.glsl.
 */
export function bendPiece(
  c: Cubic,
  force: [number, number],
  third: number,
  weights: BendWeights,
  arc: number,
  model: BendModel,
): Bent {
  const beta = bendVector(force[0], force[1], third, model.forceExponent, model.lengthExponent);
  if (model.paper) return paperBendStep(c, beta, weights[0], weights[1]);
  const bent = bendStep(c, beta, weights[0], weights[1]);
  return { curve: rescaleArc(bent.curve, arc), angle: bent.angle };
}
