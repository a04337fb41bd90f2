import { cosTurns, power, sinTurns } from '../math/trig.ts';

/** Shape of the stems of a level: what multiplies their radius. */
export interface Shape {
  /** Weber & Penn's nTaper, 0..3: 0 cylinder, 1 cone, 2 and more rounded ends. */
  taper: number;
  /** Widening towards the ground, 0 and more; the radius at z = 0 is 1 + flare times as wide. */
  flare: number;
  /** Whole number of lobes around, their depth 0..1, and how far they fade towards the tip: 0 not at all, 1 to nothing. */
  lobes: number;
  lobeDepth: number;
  lobeFade: number;
  /** Bulges along the stem and their depth 0..1. */
  bulges: number;
  bulgeDepth: number;
}

/** A factor or a radius at z, and its derivative by z. */
export type Profile = [value: number, slope: number];

/** The steepest slope given out, in lengths of the stem: a rounded end is infinitely steep at its pole. */
const STEEPEST = 1000;
const LN_100 = 4.605170185988092;
const LOG2_100 = 6.643856189774724;
const TAU = 6.283185307179586;

/**
 * Radius in metres and its slope at z in 0..1 of a stem without flare, for taper 0..3: cylinder, cone, rounded end, chain of
 * spheres. Finite everywhere; at the pole of a rounded end the slope stops at a thousand lengths of the stem.
 * Source: Weber & Penn 1995, 4.4; equations.md 6.4. Twin: shaders/branch/radius.glsl.
 */
export function taperRadius(z: number, taper: number, radius: number, length: number): Profile {
  if (radius <= 0) return [0, 0];
  const share = taper < 1 ? taper : Math.max(2 - taper, 0);
  const cone = radius * (1 - share * z);
  const coneSlope = -radius * share;
  if (taper < 1) return [cone, coneSlope];
  const left = (1 - z) * length;
  // From here on the end is a half sphere of the cone's radius, or for taper > 2 a chain of spheres that deepens.
  let height = left;
  let heightSlope = -length;
  let depth = 1;
  if (taper >= 2) {
    if (left >= cone) depth = Math.min(taper, 3) - 2;
    const d = left - 2 * cone * Math.floor(left / (2 * cone) + 0.5);
    height = Math.abs(d);
    if (d < 0) heightSlope = length;
  } else if (height >= cone) {
    return [cone, coneSlope];
  }
  const round = Math.sqrt(Math.max(cone * cone - (height - cone) * (height - cone), 0));
  const rise = coneSlope * height + (cone - height) * heightSlope;
  const roundSlope = rise / Math.max(round, 1e-6 * radius);
  const most = STEEPEST * length;
  return [cone + depth * (round - cone), Math.min(Math.max(coneSlope + depth * (roundSlope - coneSlope), -most), most)];
}

/**
 * Radius and slope of Skjermo's taper r (1 - z^t), t > 0; t <= 0 asks for a cylinder. For t < 1 the slope at 0 is that at 1e-4.
 * Source: Skjermo 2006, equations 2 and 10 (erratum E1: the slope is negative). Twin: shaders/branch/radius.glsl.
 */
export function powerTaper(z: number, radius: number, t: number): Profile {
  if (t <= 0) return [radius, 0];
  const slope = -radius * t * (t === 1 ? 1 : power(t < 1 ? Math.max(z, 1e-4) : z, t - 1));
  return [radius * (1 - power(z, t)), slope];
}

/** Factor of the flare: (f/100) 100^(1-8z) + 1. Source: Skjermo 2006, equations 3 and 10 (erratum E2). Twin: shaders/branch/radius.glsl. */
export function flare(z: number, f: number): Profile {
  const e = (f / 100) * 2 ** (LOG2_100 * (1 - 8 * z));
  return [e + 1, -8 * LN_100 * e];
}

/** Weber & Penn's flare: as above less f/100, and exactly 1 from z = 1/8, with a crease there (4.4). Twin: shaders/branch/radius.glsl. */
export function clampedFlare(z: number, f: number): Profile {
  const e = (f / 100) * 2 ** (LOG2_100 * Math.max(1 - 8 * z, 0));
  return [e + 1 - f / 100, z < 0.125 ? -8 * LN_100 * e : 0];
}

/** Factor of n bulges of depth d < 1 along the stem. Source: Skjermo 2006, equations 4 and 10. Twin: shaders/branch/radius.glsl. */
export const bulges = (z: number, n: number, d: number): Profile => [
  1 + d * sinTurns(n * z),
  TAU * n * d * cosTurns(n * z),
];

/**
 * Factor of n lobes of depth d < 1 around the stem at an angle in turns, its derivative by z, and that by the angle in radians.
 * Source: Skjermo 2006, equations 5, 10 and 11 (errata E3, E4). Twin: shaders/branch/radius.glsl.
 */
export function lobes(
  z: number,
  turns: number,
  n: number,
  d: number,
  fade: number,
): [value: number, byZ: number, byAngle: number] {
  const s = d * sinTurns(n * turns);
  const f = 1 - z * fade;
  return [1 + s * f, -fade * s, d * n * cosTurns(n * turns) * f];
}

/** A radius times the flare, bulges and lobes of a shape: radius in metres, slope by z, and q = (d radius/d angle)/radius. */
function shaped(
  taper: Profile,
  widening: Profile,
  shape: Shape,
  z: number,
  turns: number,
): [radius: number, byZ: number, q: number] {
  const b = bulges(z, shape.bulges, shape.bulgeDepth);
  const l = lobes(z, turns, shape.lobes, shape.lobeDepth, shape.lobeFade);
  const stem = taper[0] * widening[0];
  const stemSlope = taper[1] * widening[0] + taper[0] * widening[1];
  const relief = b[0] * l[0];
  const reliefSlope = b[1] * l[0] + b[0] * l[1];
  return [stem * relief, stemSlope * relief + stem * reliefSlope, l[2] / l[0]];
}

/**
 * Radius of a stem in metres at z in 0..1 of its length and at an angle in turns (0 on the side of T), its slope by z, and
 * q = (d radius/d angle)/radius, which stays finite at a tip. A piece multiplies the slope by its share z1 - z0.
 * `radius` and `length` are the stem's own. Source: Skjermo 2006, equation 6, with Weber & Penn's taper.
 * Twin: shaders/branch/radius.glsl.
 */
export const stemRadius = (
  shape: Shape,
  radius: number,
  length: number,
  z: number,
  turns: number,
): [radius: number, byZ: number, q: number] =>
  shaped(taperRadius(z, shape.taper, radius, length), flare(z, shape.flare), shape, z, turns);

/** The same with Skjermo's taper r (1 - z^t): `shape.taper` is his t. Source: Skjermo 2006, equation 6. */
export const skjermoRadius = (
  shape: Shape,
  radius: number,
  z: number,
  turns: number,
  widening: (z: number, f: number) => Profile = flare,
): [radius: number, byZ: number, q: number] =>
  shaped(powerTaper(z, radius, shape.taper), widening(z, shape.flare), shape, z, turns);
