import { generatorCubic } from '../../core/deform/generator.ts';
import type { Shape } from '../../core/deform/radius.ts';
import { type Cubic, holdArc } from '../../core/math/bezier.ts';
import { handlesOf } from '../../core/math/frames.ts';
import type { Vec3 } from '../../core/math/vec3.ts';
import type { Branch } from './branch-mesh.ts';

export const DEGREE = Math.PI / 180;

/** Every branch of the lesson starts along x; its parent stood upright. */
export const PARENT: Vec3 = [0, 0, 1];

/** A shape with nothing to it. */
export const PLAIN: Shape = { taper: 0, flare: 0, lobes: 0, lobeDepth: 0, lobeFade: 0, bulges: 0, bulgeDepth: 0 };

/** Shapes to try, after the paper's figures 12 and 13. */
export const SHAPES = {
  limb: { taper: 2.2, flare: 0.7, lobes: 5, lobeDepth: 0.1, lobeFade: 1, bulges: 3, bulgeDepth: 0.06 },
  cone: { ...PLAIN, taper: 1 },
  knobbly: { taper: 4, flare: 0.2, lobes: 0, lobeDepth: 0, lobeFade: 0, bulges: 6, bulgeDepth: 0.16 },
  cactus: { taper: 9, flare: 0, lobes: 9, lobeDepth: 0.14, lobeFade: 0, bulges: 0, bulgeDepth: 0 },
} satisfies Record<string, Shape>;

/** The paper's walk with bends in degrees, a roll at the second joint, and the length kept. */
export const walk = (length: number, b1: number, b2: number, roll = 0): Cubic =>
  holdArc(generatorCubic(length, 90 * DEGREE, b1 * DEGREE, roll * DEGREE, b2 * DEGREE), length);

/** A branch of a length in metres. */
export function branchOf(shape: Shape, radius: number, curve: Cubic): Branch {
  return { shape, radius, curve, handles: handlesOf(curve, PARENT) };
}
