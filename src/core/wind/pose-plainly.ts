import type { Quaternion } from '../math/quaternion.ts';
import type { Vec3 } from '../math/vec3.ts';
import { PIECE_LAYERS } from '../pack/layout.ts';
import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';
import type { BendModel } from './bend.ts';
import { type WaveUniforms, windForce } from './force.ts';
import { attachRoot, bendPose, type Pose, poseFromParent, type RestPiece } from './pose.ts';

/** What a pose needs of a packed tree. */
export type PiecesToPose = Pick<PackedTree, 'pieceCount' | 'pieces' | 'restPose'>;

/** The wind at one time and how it bends: what `WindFader.at` gives. */
export type WindToPose = WaveUniforms & BendModel;

/** Floats from one layer or target to the next. */
export const planeOf = (array: TexelArray): number => layerStart(array, 1);

/** The rest data of piece i, its parent (-1 for a root) and the place where its stem feels the wind. */
export function restPieceOf(
  { pieces }: PiecesToPose,
  i: number,
): { rest: RestPiece; parent: number; tip: [number, number] } {
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
    tip: [data[t], data[t + 1]],
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
  return { curve: { p0: at(0), p1: at(1), p2: at(2), p3: at(3) }, o: [w(0), w(1), w(2)], angle: w(3) };
}

/** Writes a pose as POSE_TARGETS says. */
export function writePose(data: Float32Array, plane: number, i: number, { curve, o, angle }: Pose): void {
  const points = [curve.p0, curve.p1, curve.p2, curve.p3];
  for (let target = 0; target < 4; target++) {
    const k = target * plane + 4 * i;
    data.set(points[target], k);
    data[k + 3] = target < 3 ? o[target] : angle;
  }
}

/**
 * The pose of every piece of a tree in a wind, laid out as `restPose`: the reference for the wind pass, plain rather than fast.
 *
 * `exact` poses parents before their children. `lagged` takes every parent from `previous`, the pose of the last step (the rest
 * pose by default), as the paper does; `out` must then be another array. Source: Skjermo 2007, 4.2; equations.md 4.1.
 */
export function poseTreePlainly(
  tree: PiecesToPose,
  wind: WindToPose,
  mode: 'exact' | 'lagged',
  previous: Float32Array = tree.restPose.data,
  out: Float32Array = new Float32Array(tree.restPose.data.length),
): Float32Array {
  const plane = planeOf(tree.restPose);
  const parents = mode === 'lagged' ? previous : out;
  for (let i = 0; i < tree.pieceCount; i++) {
    const { rest, parent, tip } = restPieceOf(tree, i);
    const force = windForce(wind, tip[0], tip[1]);
    let pose: Pose;
    if (parent < 0) pose = bendPose(attachRoot(poseOf(previous, plane, i).curve.p0, rest), rest, force, wind);
    else {
      const p = poseOf(parents, plane, parent);
      pose = poseFromParent(p.curve, p.o, rest, force, wind);
    }
    writePose(out, plane, i, pose);
  }
  return out;
}
