import { bezierPoint, type Cubic } from '../math/bezier.ts';
import { type Handles, handlesOf, projectedHandlesOf, sectionFrame } from '../math/frames.ts';
import { matrixFromQuaternion, type Quaternion } from '../math/quaternion.ts';
import { add, type Mat3, multiply, transform, type Vec3 } from '../math/vec3.ts';
import { type BendWeights, bendPiece, type Push } from './bend.ts';

/** What a piece is at rest: one entry of PIECE_LAYERS. Metres; control points in the base frame. */
export interface RestPiece {
  /** Bezier parameter of the attachment on the parent. */
  v: number;
  /** Rotation of the base frame in the parent's section frame at v; of a root, in tree space. */
  orientation: Quaternion;
  p1x: number;
  p2: Vec3;
  p3: Vec3;
  arc: number;
  weights: BendWeights;
  /** A third of the stem's length. */
  third: number;
}

/** Where a piece is: its curve in tree space, its orientation vector, and how hard its leaves are shaken, metres of force. */
export interface Pose {
  curve: Cubic;
  o: Vec3;
  stir: number;
}

/** The handles of a parent; `paper`: in the printed form, for teaching. Twin: shaders/wind/pose.glsl. */
export const parentHandles = (parent: Cubic, o: Vec3, paper: boolean): Handles =>
  paper ? projectedHandlesOf(parent, o) : handlesOf(parent, o);

/** Control points and orientation vector of a piece whose base frame is `frame` and whose P0 is `at`. Twin: shaders/wind/pose.glsl. */
export const placePiece = (at: Vec3, frame: Mat3, rest: RestPiece): Pose => ({
  curve: {
    p0: at,
    p1: add(at, transform(frame, [rest.p1x, 0, 0])),
    p2: add(at, transform(frame, rest.p2)),
    p3: add(at, transform(frame, rest.p3)),
  },
  o: frame[1],
  stir: 0,
});

/**
 * A piece at its parent's attachment, unbent: P_i = C(v) + [U T^ S^](v) q p_i, O = the second column.
 * Source: Skjermo 2007, 4.2 (errata E33, E34); equations.md section 4. Twin: shaders/wind/pose.glsl.
 */
export function attachPiece(parent: Cubic, parentO: Vec3, rest: RestPiece, paper = false): Pose {
  const section = sectionFrame(parent, parentHandles(parent, parentO, paper), rest.v);
  return placePiece(bezierPoint(parent, rest.v), multiply(section, matrixFromQuaternion(rest.orientation)), rest);
}

/** A root, which stands where it stood: `at` is its P0, and its orientation is in tree space. Twin: shaders/wind/pose.glsl. */
export const attachRoot = (at: Vec3, rest: RestPiece): Pose =>
  placePiece(at, matrixFromQuaternion(rest.orientation), rest);

/** A placed piece bent by a push, its leaves shaken by `stir`; `paper`: in the printed form. Twin: shaders/wind/pose.glsl. */
export const bendPose = (placed: Pose, rest: RestPiece, push: Push, stir: number, paper = false): Pose => ({
  curve: bendPiece(placed.curve, push, rest.arc, paper),
  o: placed.o,
  stir,
});

/** A child's pose from its parent's: attached, then bent. Source: Skjermo 2007, 4.2 and equation 17. Twin: shaders/wind/pose.glsl. */
export const poseFromParent = (
  parent: Cubic,
  parentO: Vec3,
  rest: RestPiece,
  push: Push,
  stir: number,
  paper = false,
): Pose => bendPose(attachPiece(parent, parentO, rest, paper), rest, push, stir, paper);
