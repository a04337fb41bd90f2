import type { Shape } from '../deform/radius.ts';
import { bezierDerivative, type Cubic } from '../math/bezier.ts';
import { dot, length, subtract, type Vec3 } from '../math/vec3.ts';
import type { GradeRule } from './mesh-detail.ts';
import type { PieceTable } from './piece-table.ts';

/** Rings of one piece may not be nearer to each other than this part of it. */
const NEAREST = 0.02;

/** Most rings of a piece, whatever its shape asks for. */
const MOST = 96;

const DEGREE = Math.PI / 180;

/** Angle between two directions in radians: by the chord, so that no engine's arc cosine has a say. */
function angleBetween(a: Vec3, b: Vec3): number {
  const lengths = length(a) * length(b);
  if (lengths < 1e-24) return 0;
  const square = Math.max(0, 2 - (2 * dot(a, b)) / lengths);
  return Math.sqrt(square) * (1 + square / 24 + (3 * square * square) / 640);
}

/** How far the tangent of a curve turns, radians. */
export function turnOf(c: Cubic): number {
  const middle = bezierDerivative(c, 0.5);
  return (
    angleBetween(subtract(c.p1, c.p0), bezierDerivative(c, 0.25)) +
    angleBetween(bezierDerivative(c, 0.25), middle) +
    angleBetween(middle, bezierDerivative(c, 0.75)) +
    angleBetween(bezierDerivative(c, 0.75), subtract(c.p3, c.p2))
  );
}

/**
 * Bezier parameters in (0, 1] at which a piece has a ring, growing, the last always 1; `rest` is its curve at rest, so that every pose has
 * the same rings. `least`: bands at least, where wind is to bend it.
 */
export function ringsOf(
  piece: number,
  rest: Cubic,
  table: PieceTable,
  shape: Shape,
  rule: GradeRule,
  least: number,
): number[] {
  const [z0, z1] = [table.z0[piece]!, table.z1[piece]!];
  const part = z1 - z0;
  const radius = table.baseRadius[piece]!;
  const stem = table.length[piece]!;
  let bands = Math.max(least, Math.ceil(turnOf(rest) / (rule.turn * DEGREE)));
  if (shape.bulgeDepth > 0) bands = Math.max(bands, Math.ceil(6 * shape.bulges * part));
  if (shape.taper > 2) bands = Math.max(bands, Math.ceil((3 * stem * part) / Math.max(radius, 1e-9)));
  bands = Math.max(1, Math.min(MOST, bands));
  if (z0 === 0 && shape.flare > 0) return flared(Math.max(bands, rule.flare));
  const wanted: number[] = [];
  const reach = table.parentRadius[piece]! + 3 * radius;
  if (table.parentRadius[piece]! > 0 && stem > 0 && radius > rule.sag) {
    for (let k = 1; k <= rule.collar; k++) wanted.push((reach * k) / (rule.collar * stem));
  }
  if (shape.taper > 1 && z1 > 1 - 1e-6 && radius > rule.sag) {
    // The half sphere at the end: where it begins, and one on its way.
    const cone = radius * (1 - Math.max(2 - shape.taper, 0));
    const left = cone + (radius - cone) * Math.min(1, cone / Math.max(stem, 1e-9));
    for (const share of [1, 0.3, 0.08]) wanted.push(1 - (share * left) / Math.max(stem, 1e-9));
  }
  const rings = wanted.map((z) => (z - z0) / Math.max(part, 1e-9)).filter((u) => u > NEAREST && u < 1 - NEAREST);
  for (let k = 1; k < bands; k++) {
    const u = k / bands;
    if (rings.every((other) => Math.abs(other - u) > Math.max(NEAREST, 0.3 / bands))) rings.push(u);
  }
  return [...rings, 1].sort((a, b) => a - b);
}

/** The flare falls to a hundredth over an eighth of the stem: rings crowd towards the ground, as the shader's do. */
const flared = (bands: number): number[] =>
  Array.from({ length: bands }, (_, k) => {
    const v = (k + 1) / bands;
    return v * (0.15 + 0.85 * v);
  });
