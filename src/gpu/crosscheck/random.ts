import { hashPcg, hashUnit } from '../../core/math/hash.ts';
import type { Quaternion } from '../../core/math/quaternion.ts';
import { unit, type Vec3 } from '../../core/math/vec3.ts';

/** A stream of numbers in [0, 1) that is the same on every machine: the checks of a report can be run again. */
export type Random = () => number;

/** The stream of a seed. */
export function randomStream(seed: number): Random {
  let state = hashPcg(seed);
  return () => {
    state = hashPcg(state);
    return hashUnit(state);
  };
}

/** A number in [low, high). */
export const between = (random: Random, low: number, high: number): number => low + (high - low) * random();

/** A number between `low` and `high`, evenly over the orders of magnitude; both > 0. */
export const magnitude = (random: Random, low: number, high: number): number =>
  low * Math.exp(Math.log(high / low) * random());

/** A unit vector, evenly over the sphere. */
export function direction(random: Random): Vec3 {
  const z = 2 * random() - 1;
  const r = Math.sqrt(1 - z * z);
  const angle = 2 * Math.PI * random();
  return [r * Math.cos(angle), r * Math.sin(angle), z];
}

/** A unit vector within `angle` radians of the unit vector `axis`. */
export function near(random: Random, axis: Vec3, angle: number): Vec3 {
  const off = direction(random);
  const turn = Math.tan(Math.min(angle, 1.5) * random());
  const along = off[0] * axis[0] + off[1] * axis[1] + off[2] * axis[2];
  const side = unit([off[0] - along * axis[0], off[1] - along * axis[1], off[2] - along * axis[2]], [1, 0, 0]);
  return unit([axis[0] + turn * side[0], axis[1] + turn * side[1], axis[2] + turn * side[2]]);
}

/** A rotation, evenly over all. */
export function rotation(random: Random): Quaternion {
  const [a, b, c] = [random(), 2 * Math.PI * random(), 2 * Math.PI * random()];
  const [s, r] = [Math.sqrt(1 - a), Math.sqrt(a)];
  return [s * Math.sin(b), s * Math.cos(b), r * Math.sin(c), r * Math.cos(c)];
}
