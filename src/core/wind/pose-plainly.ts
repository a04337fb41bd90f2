import type { Quaternion } from '../math/quaternion.ts';
import { cross, type Mat3, subtract, unit, type Vec3 } from '../math/vec3.ts';
import { PIECE_LAYERS } from '../pack/layout.ts';
import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';
import { attachPiece, attachRoot, bendPose, type Pose, type RestPiece } from './pose.ts';
import { type Bends, piecePush, type WindToPose } from './push.ts';

/** What a pose needs of a packed tree. */
export type PiecesToPose = Pick<PackedTree, 'pieceCount' | 'pieces' | 'restPose'>;

/** Floats from one layer or target to the next. */
export const planeOf = (array: TexelArray): number => layerStart(array, 1);

/** The rest data of piece i, its parent (-1 for a root) and the place where its stem feels the wind. */
export function restPieceOf({ pieces }: PiecesToPose, i: number): { rest: RestPiece; parent: number; tip: Vec3 } {
  const { data } = pieces;
  const plane = planeOf(pieces);
  const at = (layer: number): number => layer * plane + 4 * i;
  const a = at(PIECE_LAYERS.ATTACH);
  const q = at(PIECE_LAYERS.ORIENT);
  const h = at(PIECE_LAYERS.HANDLE);
  const e = at(PIECE_LAYERS.END);
  const t = at(PIECE_LAYERS.TIP);
  return {
    parent: data[a],
    tip: [data[t], data[t + 1], data[t + 2]],
    rest: {
      v: data[a + 1],
      weights: [data[a + 2], data[a + 3]],
      orientation: [data[q], data[q + 1], data[q + 2], data[q + 3]] as Quaternion,
      p2: [data[h], data[h + 1], data[h + 2]],
      p1x: data[h + 3],
      p3: [data[e], data[e + 1], data[e + 2]],
      arc: data[e + 3],
      third: data[t + 3],
    },
  };
}

/** The pose of piece i in an array laid out as POSE_TARGETS, `plane` floats a target. */
export function poseOf(data: Float32Array, plane: number, i: number): Pose {
  const at = (target: number): Vec3 => {
    const k = target * plane + 4 * i;
    return [data[k], data[k + 1], data[k + 2]];
  };
  const w = (target: number): number => data[target * plane + 4 * i + 3];
  return { curve: { p0: at(0), p1: at(1), p2: at(2), p3: at(3) }, o: [w(0), w(1), w(2)], stir: w(3) };
}

/** Writes a pose as POSE_TARGETS says. */
export function writePose(data: Float32Array, plane: number, i: number, { curve, o, stir }: Pose): void {
  const points = [curve.p0, curve.p1, curve.p2, curve.p3];
  for (let target = 0; target < 4; target++) {
    const k = target * plane + 4 * i;
    data.set(points[target], k);
    data[k + 3] = target < 3 ? o[target] : stir;
  }
}

/**
 * The pose of every piece of a tree in a wind, laid out as `restPose`: the reference for the wind pass, plain rather than fast.
 *
 * `exact` poses parents before their children. `lagged` takes every parent from `previous`, the pose of the last step (the rest
 * pose by default), as the paper does; `out` must then be another array. `bends` is what the bend models need that are more than a
 * function of the wind. Source: Skjermo 2007, 4.2; equations.md 4.1.
 */
export function poseTreePlainly(
  tree: PiecesToPose,
  wind: WindToPose,
  mode: 'exact' | 'lagged',
  previous: Float32Array = tree.restPose.data,
  out: Float32Array = new Float32Array(tree.restPose.data.length),
  bends: Bends = {},
): Float32Array {
  const plane = planeOf(tree.restPose);
  const parents = mode === 'lagged' ? previous : out;
  for (let i = 0; i < tree.pieceCount; i++) {
    const { rest, parent, tip } = restPieceOf(tree, i);
    const placed = parent < 0 ? rootOf(previous, plane, i, rest) : childOf(parents, plane, parent, rest, wind.paper);
    const { push, stir } = piecePush(i, rest, tip, baseFrame(placed), wind, bends);
    writePose(out, plane, i, bendPose(placed, rest, push, stir, wind.paper));
  }
  return out;
}

const rootOf = (pose: Float32Array, plane: number, i: number, rest: RestPiece): Pose =>
  attachRoot(poseOf(pose, plane, i).curve.p0, rest);

function childOf(pose: Float32Array, plane: number, parent: number, rest: RestPiece, paper: boolean): Pose {
  const { curve, o } = poseOf(pose, plane, parent);
  return attachPiece(curve, o, rest, paper);
}

/** The frame of a piece at its base: columns L, T and S. */
function baseFrame({ curve, o }: Pose): Mat3 {
  const l = unit(subtract(curve.p1, curve.p0));
  return [l, o, cross(l, o)];
}
