import { power as exactPower } from '../grow/elementary.ts';
import { type Cubic, holdArc } from '../math/bezier.ts';
import { power } from '../math/trig.ts';
import { add, addScaled, dot, length, type Mat3, mix, scale, subtract, transform, type Vec3 } from '../math/vec3.ts';

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

/** Largest change of direction: a turn of 89.99 degrees. Beyond it float32 might overflow, and nothing turns any more. */
const MOST_BEND = 1e4;

/**
 * The change of direction that a force (metres, horizontal) gives a stem: G(F)/l^m with G(F) = F |F|^(p-1), at most 1e4. `third` is
 * l, a third of the stem's length in metres; our winds have p = 1 and m = 0.6, the paper p = 1.8 and m = 2.
 * Source: Skjermo 2007, equations 14 and 16 (errata E27, E28). Twin: shaders/wind/bend.glsl.
 */
export function bendVector(fx: number, fy: number, third: number, p: number, m: number): Vec3 {
  const gain = p === 1 ? 1 : Math.min(power(Math.sqrt(fx * fx + fy * fy), p - 1), 1e6);
  const softness = m === 1 ? 1 / third : m === 0 ? 1 : third > 0 ? power(third, -m) : 1e6;
  const factor = gain * Math.min(softness, 1e6);
  const most = Math.max(Math.abs(fx), Math.abs(fy)) * factor;
  const s = most > MOST_BEND ? (MOST_BEND / most) * factor : factor;
  return [fx * s, fy * s, 0];
}

/** What is added to the directions of the second and the third edge of a piece. */
export interface Push {
  second: Vec3;
  third: Vec3;
}

/** A change of direction shared out by the weights of a piece, times the softness of the tree. Twin: shaders/wind/bend.glsl. */
export const weightedPush = (beta: Vec3, [w2, w3]: BendWeights, softness = 1): Push => ({
  second: scale(beta, w2 * softness),
  third: scale(beta, w3 * softness),
});

/** How the wind's force becomes bend: exponents p and m, the softness of the tree (1/stiffness), and the paper's forms. */
export interface BendModel {
  forceExponent: number;
  lengthExponent: number;
  softness: number;
  paper: boolean;
}

/**
 * The bend model `direct`, the paper's: at once as far as the force (metres) pushes. Source: Skjermo 2007, equation 16.
 * Twin: shaders/wind/bend.glsl.
 */
export const directPush = (force: [number, number], third: number, weights: BendWeights, model: BendModel): Push =>
  weightedPush(
    bendVector(force[0], force[1], third, model.forceExponent, model.lengthExponent),
    weights,
    model.softness,
  );

/**
 * A bend given along the columns L, T and S of a frame: that at rest for a spring, the placed one for sway.
 * Twin: shaders/wind/bend.glsl.
 */
export const framePush = (frame: Mat3, q: Vec3, weights: BendWeights, softness: number): Push =>
  weightedPush(transform(frame, q), weights, softness);

/** From one model's push to another's: f is 0 for the first, 1 for the second. Twin: shaders/wind/bend.glsl. */
export const mixPush = (a: Push, b: Push, f: number): Push => ({
  second: mix(a.second, b.second, f),
  third: mix(a.third, b.third, f),
});

/**
 * The edge e turned by adding `push` to its direction; its length is kept. The part of a push against the edge does nothing: nothing
 * turns by a right angle or more, and no edge flips over when the wind meets its very end. Twin: shaders/wind/bend.glsl.
 */
export function leanEdge(e: Vec3, push: Vec3): Vec3 {
  const l = length(e);
  const d = addScaled(addScaled(e, push, l), e, -Math.min(dot(e, push) / Math.max(l, 1e-30), 0));
  return scale(d, l / Math.max(length(d), 1e-30));
}

/** Least cosine between neighbouring edges of a bent piece, 105 degrees: what a piece at rest folds at most (pieces/chain.ts), but for a few. */
export const FOLD = -0.26;

/** The cosine of the angle between two edges, 0 where one has no length. Twin: shaders/wind/bend.glsl. */
export const edgeCosine = (a: Vec3, b: Vec3): number => dot(a, b) / Math.sqrt(Math.max(dot(a, a) * dot(b, b), 1e-36));

/**
 * The edge b, turned towards the edge a before it where it would fold back on it further than to the cosine `least`: a piece that folds
 * turns its frames over within a hair's breadth, and its arc length has no quadrature. Within 2 degrees of the way back it also gets
 * shorter: there no side is nearer than another. Twin: shaders/wind/bend.glsl.
 */
export function unfoldEdge(a: Vec3, b: Vec3, least: number): Vec3 {
  const c = edgeCosine(a, b);
  if (c >= least) return b;
  const aa = Math.max(dot(a, a), 1e-30);
  const along = least * Math.sqrt(dot(b, b) / aa);
  const aside = Math.sqrt((1 - least * least) / Math.max(1 - c * c, 1e-3));
  return addScaled(scale(a, along), addScaled(b, a, -dot(a, b) / aa), aside);
}

/**
 * Bends a placed piece: its second and third edge lean and keep their lengths, P0 and P1 stay, and no two edges fold by more than 105
 * degrees or what they fold at rest. Source: Skjermo 2007, equation 17 (errata E29, E30). Twin: shaders/wind/bend.glsl.
 */
export function leanPiece(c: Cubic, push: Push): Cubic {
  const e1 = subtract(c.p1, c.p0);
  const e2 = subtract(c.p2, c.p1);
  const e3 = subtract(c.p3, c.p2);
  const f2 = unfoldEdge(e1, leanEdge(e2, push.second), Math.min(edgeCosine(e1, e2), FOLD));
  const f3 = unfoldEdge(f2, leanEdge(e3, push.third), Math.min(edgeCosine(e2, e3), FOLD));
  const p2 = add(c.p1, f2);
  return { p0: c.p0, p1: c.p1, p2, p3: add(p2, f3) };
}

/** The edge e turned by adding all of `push` to its direction; its length is kept. Against the edge itself nothing can turn it. */
export function turnEdge(e: Vec3, push: Vec3): Vec3 {
  const l = length(e);
  const d = addScaled(e, push, l);
  const n = length(d);
  return n > 1e-6 * l ? scale(d, l / n) : e;
}

/**
 * Equation 17 with its units repaired and nothing else (errata E29, E30): as `leanPiece`, but a push against an edge shortens what
 * the rest of the push has to turn, and turns it over where it is stronger than the edge is long. What the vectors hold.
 */
export function bendStep(c: Cubic, push: Push): Cubic {
  const p2 = add(c.p1, turnEdge(subtract(c.p2, c.p1), push.second));
  return { p0: c.p0, p1: c.p1, p2, p3: add(p2, turnEdge(subtract(c.p3, c.p2), push.third)) };
}

/**
 * The step as printed, made consistent: the print divides e + b by |e| and so makes every edge 1 m long; times that length
 * it says e + b, and the branch stretches with the wind. For teaching. Source: Skjermo 2007, equation 17 (erratum E29).
 * Twin: shaders/wind/bend.glsl.
 */
export function paperBendStep(c: Cubic, push: Push): Cubic {
  const e2 = subtract(c.p2, c.p1);
  const e3 = subtract(c.p3, c.p2);
  const p2 = addScaled(add(c.p1, e2), push.second, length(e2));
  return { p0: c.p0, p1: c.p1, p2, p3: addScaled(add(p2, e3), push.third, length(e3)) };
}

/**
 * Bends a placed piece and gives it its arc length at rest back, or, for `paper`, as printed.
 * Source: equations.md 3.4 and 5.5. Twin: shaders/wind/bend.glsl.
 */
export const bendPiece = (c: Cubic, push: Push, arc: number, paper = false): Cubic =>
  paper ? paperBendStep(c, push) : holdArc(leanPiece(c, push), arc);
