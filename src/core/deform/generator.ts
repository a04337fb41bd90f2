import type { Cubic } from '../math/bezier.ts';
import { addScaled, type Mat3, multiply, type Vec3 } from '../math/vec3.ts';

/** Rotation by `a` radians about x. */
export const aboutX = (a: number): Mat3 => [
  [1, 0, 0],
  [0, Math.cos(a), Math.sin(a)],
  [0, -Math.sin(a), Math.cos(a)],
];

/** Rotation by `a` radians about z. */
export const aboutZ = (a: number): Mat3 => [
  [Math.cos(a), Math.sin(a), 0],
  [-Math.sin(a), Math.cos(a), 0],
  [0, 0, 1],
];

/**
 * A branch of three equal edges, L/3 each, from its base along x: each joint rolls by a about the edge and bends by b about the new
 * z; radians, |b| below a quarter turn. Source: Skjermo 2006, 2.1; equations.md 3.3.
 */
export function generatorCubic(length: number, a1: number, b1: number, a2: number, b2: number): Cubic {
  const l = length / 3;
  const p1: Vec3 = [l, 0, 0];
  const first = multiply(aboutX(a1), aboutZ(b1));
  const second = multiply(multiply(first, aboutX(a2)), aboutZ(b2));
  const p2 = addScaled(p1, first[0], l);
  return { p0: [0, 0, 0], p1, p2, p3: addScaled(p2, second[0], l) };
}

/**
 * The two bends that give a curve the turns of its halves, so that end tangent and mean direction match, S-shapes too. In the unit
 * of the arguments; for results up to 75 degrees. Source: equations.md 3.3 (erratum E22).
 */
export const generatorBends = (turn1: number, turn2: number): [b1: number, b2: number] => [
  (5 * turn1 - turn2) / 4,
  (5 * turn2 - turn1) / 4,
];

/**
 * Length of the two end handles with which a cubic of this arc length follows a circle through `turn` radians (below a whole turn).
 * Source: equations.md 7.1.
 */
export const arcHandle = (arcLength: number, turn: number): number =>
  Math.abs(turn) < 1e-6 ? arcLength / 3 : ((4 / 3) * Math.tan(turn / 4) * arcLength) / turn;
