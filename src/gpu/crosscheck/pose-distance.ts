import { bezierDerivative, type Cubic } from '../../core/math/bezier.ts';
import { length } from '../../core/math/vec3.ts';
import { POSE_TARGETS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { planeOf, poseOf } from '../../core/wind/pose-plainly.ts';

/** How far two poses of a tree are apart at worst. */
interface Distance {
  /** Control points, in parts of the tree's height. */
  readonly points: number;
  /** Orientation vectors, as the length of their difference. */
  readonly orientation: number;
  /** How hard leaves are shaken: in parts of the hardest. */
  readonly stir: number;
}

const orInfinity = (x: number): number => (Number.isNaN(x) ? Number.POSITIVE_INFINITY : x);

/** Compares every piece of two poses; what is not a number is infinitely far. */
export function poseDistance(tree: PackedTree, a: Float32Array, b: Float32Array): Distance {
  const plane = planeOf(tree.restPose);
  const height = tree.bounds[5] - tree.bounds[2];
  let points = 0;
  let orientation = 0;
  let stir = 0;
  let hardest = 1e-9;
  for (let i = 0; i < tree.pieceCount; i++) {
    let turned = 0;
    for (let target = 0; target < 4; target++) {
      const at = target * plane + 4 * i;
      const away = Math.hypot(a[at] - b[at], a[at + 1] - b[at + 1], a[at + 2] - b[at + 2]);
      points = Math.max(points, orInfinity(away) / height);
      const other = Math.abs(a[at + 3] - b[at + 3]);
      if (target < POSE_TARGETS.P3) turned = Math.hypot(turned, other);
      else {
        stir = Math.max(stir, orInfinity(other));
        hardest = Math.max(hardest, b[at + 3]);
      }
    }
    orientation = Math.max(orientation, orInfinity(turned));
  }
  return { points, orientation, stir: stir / hardest };
}

/** How far the wind moves the tips at most, in parts of the tree's height: a still tree would agree with anything. */
export function movement(tree: PackedTree, pose: Float32Array): number {
  const end = layerStart(tree.restPose, POSE_TARGETS.P3);
  const rest = tree.restPose.data;
  let most = 0;
  for (let i = end; i < end + 4 * tree.pieceCount; i += 4) {
    most = Math.max(most, Math.hypot(pose[i] - rest[i], pose[i + 1] - rest[i + 1], pose[i + 2] - rest[i + 2]));
  }
  return most / (tree.bounds[5] - tree.bounds[2]);
}

/** Parts into which a curve is cut to be measured: the rule's error is then below that of float32. */
const PARTS = 64;

/** Arc length by Simpson's rule on many parts: not by the rule that the pass holds it with. */
function measuredArc(curve: Cubic): number {
  let sum = 0;
  for (let i = 0; i <= 2 * PARTS; i++) {
    const weight = i === 0 || i === 2 * PARTS ? 1 : i % 2 === 1 ? 4 : 2;
    sum += weight * length(bezierDerivative(curve, i / (2 * PARTS)));
  }
  return sum / (6 * PARTS);
}

/** By how much of its arc length at rest a piece is longer or shorter at most. */
export function stretching(tree: PackedTree, pose: Float32Array): number {
  const plane = planeOf(tree.restPose);
  let most = 0;
  for (let i = 0; i < tree.pieceCount; i++) {
    const rest = measuredArc(poseOf(tree.restPose.data, plane, i).curve);
    const now = measuredArc(poseOf(pose, plane, i).curve);
    most = Math.max(most, orInfinity(Math.abs(now / rest - 1)));
  }
  return most;
}

/** Numbers that are not the same in two states or poses, bit for bit; NaN is never the same. */
export function differing(a: Float32Array | null, b: Float32Array | null): number {
  if (!a || !b || a.length !== b.length) return Number.POSITIVE_INFINITY;
  let n = 0;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) n++;
  return n;
}
