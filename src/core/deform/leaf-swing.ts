import { sinTurns } from '../math/trig.ts';
import { add, addScaled, cross, dot, length, scale, type Vec3 } from '../math/vec3.ts';

/** How the wind turns a leaf about the foot of its stalk, where it stays. */
export interface LeafSwing {
  /** Sines of the angles about the stalk and across it, each within a right angle. */
  readonly sines: readonly [roll: number, pitch: number];
  /** How far the blade leans downwind: tangent of the angle. */
  readonly lean: number;
}

const clamp = (x: number, most: number): number => Math.min(most, Math.max(-most, x));

/**
 * How a leaf swings that is shaken by `stir` metres of force; `own` and `phase` are its own numbers, 0..1. `pliant`: widest angle of
 * its flutter in radians, which says how soft its stalk is. `beats`: time in sixteenths of a beat, 0..1; each leaf beats a whole number
 * of times in sixteen, so that time may wrap. Source: ours. Twin: shaders/leaf/swing.glsl.
 */
export function leafSwing(stir: number, own: number, phase: number, pliant: number, beats: number): LeafSwing {
  const beat = Math.floor(11 + 11 * own);
  const hard = 1 - 2 ** (-12 * stir);
  const x = Math.min(1, Math.max(0, (stir - 0.1) * 2));
  const stream = x * x * (3 - 2 * x);
  const rest = 0.65 + 0.35 * sinTurns(Math.floor(2 + 3 * phase) * beats + 3 * own);
  const shake = sinTurns(beat * beats + phase) + 0.5 * sinTurns((beat + 6) * beats + 2 * phase);
  const nod = sinTurns((beat - 4) * beats + 3 * phase) - 0.4;
  const wide = pliant * hard * rest * (1 - 0.6 * stream);
  const fast = pliant * stream;
  const roll = 0.75 * wide * shake + 0.3 * fast * sinTurns((2 * beat + 5) * beats + 5 * phase);
  const pitch = 0.4 * wide * nod + 0.2 * fast * sinTurns((2 * beat + 9) * beats + 7 * phase);
  const lean = pliant * 4.5 * (1 - 2 ** (-2.4 * stir)) * (0.7 + 0.6 * own) * (1 + 0.12 * shake);
  return { sines: [clamp(roll, 0.95), clamp(pitch, 0.95)], lean };
}

/**
 * Where the unit vector d comes to that leans by `lean` along `way` (horizontal, at most 1 long): by what of it lies across d, so that a
 * leaf that points into the wind does not turn over. Twin: shaders/leaf/swing.glsl.
 */
export function leanTowards(d: Vec3, way: readonly [x: number, y: number], lean: number): Vec3 {
  const w: Vec3 = [way[0], way[1], 0];
  const e = addScaled(d, addScaled(w, d, -dot(w, d)), lean);
  return scale(e, 1 / length(e));
}

/** a carried along by the shortest turn of the unit vector d to the unit vector e, less than a right angle away. Twin: shaders/leaf/swing.glsl. */
export function turnAlong(a: Vec3, d: Vec3, e: Vec3): Vec3 {
  const k = cross(d, e);
  const b = cross(k, a);
  return addScaled(add(a, b), cross(k, b), 1 / (1 + dot(d, e)));
}
