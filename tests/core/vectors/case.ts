import type { Cubic } from '../../../src/core/math/bezier.ts';
import type { Mat3, Vec3 } from '../../../src/core/math/vec3.ts';

/** Turns the input of a case into what the code gives for it, under the keys of the case's output. */
export type Adapter = (input: never) => Readonly<Record<string, unknown>>;
export type Adapters = Readonly<Record<string, Adapter>>;

/** Four control points, as the cases write them. */
export type Points = [Vec3, Vec3, Vec3, Vec3];

export const cubicOf = ([p0, p1, p2, p3]: Points): Cubic => ({ p0, p1, p2, p3 });
export const pointsOf = ({ p0, p1, p2, p3 }: Cubic): Points => [p0, p1, p2, p3];

/** The cases write matrices as lists of rows, the code as columns: the transpose leads either way. */
export const transposed = (m: Mat3): Mat3 => [0, 1, 2].map((i) => [m[0][i], m[1][i], m[2][i]]) as Mat3;

export const TAU = 2 * Math.PI;
