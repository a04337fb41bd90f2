import type { Cubic } from '../../../src/core/math/bezier.ts';
import { handlesOf, sectionFrame } from '../../../src/core/math/frames.ts';
import type { Quaternion } from '../../../src/core/math/quaternion.ts';
import type { Mat3, Vec3 } from '../../../src/core/math/vec3.ts';
import type { Pieces } from '../../../src/core/pieces/pieces.ts';
import { attachPiece, attachRoot, type Pose, type RestPiece } from '../../../src/core/wind/pose.ts';

const three = (a: Float32Array, at: number): Vec3 => [a[at], a[at + 1], a[at + 2]];

/** A piece as the reference pose of core/wind reads it. */
export const restOf = (pieces: Pieces, i: number): RestPiece => ({
  v: pieces.v[i],
  orientation: Array.from(pieces.orientation.subarray(4 * i, 4 * i + 4)) as Quaternion,
  p1x: pieces.local[7 * i],
  p2: three(pieces.local, 7 * i + 1),
  p3: three(pieces.local, 7 * i + 4),
  arc: pieces.arc[i],
  weights: [0, 0],
  third: 1,
});

export const curveOf = ({ control }: Pieces, i: number): Cubic => ({
  p0: three(control, 12 * i),
  p1: three(control, 12 * i + 3),
  p2: three(control, 12 * i + 6),
  p3: three(control, 12 * i + 9),
});

/** The section frame of a piece of the rest pose. */
export const frameAt = (pieces: Pieces, i: number, v: number): Mat3 => {
  const curve = curveOf(pieces, i);
  return sectionFrame(curve, handlesOf(curve, three(pieces.orient, 3 * i)), v);
};

/** The whole tree posed without wind from what is stored of it, parents first, every step rounded to float32. */
export function poseAtRest(pieces: Pieces): Pose[] {
  const poses: Pose[] = [];
  for (let i = 0; i < pieces.count; i++) {
    const rest = restOf(pieces, i);
    const parent = pieces.parent[i];
    const pose =
      parent < 0
        ? attachRoot(three(pieces.rootPosition, 3 * i), rest)
        : attachPiece(poses[parent].curve, poses[parent].o, rest);
    const f = (a: Vec3): Vec3 => [Math.fround(a[0]), Math.fround(a[1]), Math.fround(a[2])];
    const { p0, p1, p2, p3 } = pose.curve;
    poses.push({ curve: { p0: f(p0), p1: f(p1), p2: f(p2), p3: f(p3) }, o: f(pose.o), stir: 0 });
  }
  return poses;
}

/** Largest distance between the control points of those poses and the stored rest pose, and of the orientation vectors. */
export function restError(pieces: Pieces): { position: number; orient: number } {
  const poses = poseAtRest(pieces);
  let position = 0;
  let orient = 0;
  poses.forEach(({ curve, o }, i) => {
    [curve.p0, curve.p1, curve.p2, curve.p3].forEach((p, k) => {
      for (let j = 0; j < 3; j++) {
        position = Math.max(position, Math.abs(p[j] - pieces.control[12 * i + 3 * k + j]));
      }
    });
    for (let j = 0; j < 3; j++) orient = Math.max(orient, Math.abs(o[j] - pieces.orient[3 * i + j]));
  });
  return { position, orient };
}
