import { distance } from '../../core/math/vec3.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { createWindState, windStateAt } from '../../core/wind/fade.ts';
import { planeOf, poseOf } from '../../core/wind/pose-plainly.ts';
import { poseTree } from '../../core/wind/pose-tree.ts';
import type { Wind } from '../../core/wind/wind.ts';

/** A tree posed both ways at one time. */
export interface BothPoses {
  readonly exact: Float32Array;
  readonly lagged: Float32Array;
}

/** The depth of each piece: how many parents it has. */
export const depthOf = ({ depthStart }: PackedTree, piece: number): number => {
  let depth = 0;
  while (piece >= (depthStart[depth + 1] ?? Number.POSITIVE_INFINITY)) depth++;
  return depth;
};

/** The paper's pose and the exact one at step n of `rate` steps a second. After as many steps as there are depths nothing else matters. */
export function bothPoses(tree: PackedTree, wind: Wind, step: number, rate: number): BothPoses {
  const state = createWindState();
  const depths = tree.depthStart.length - 1;
  let lagged: Float32Array = tree.restPose.data;
  for (let n = step - depths; n <= step; n++)
    lagged = poseTree(tree, windStateAt(wind, n / rate, undefined, state), 'lagged', lagged);
  return { exact: poseTree(tree, windStateAt(wind, step / rate, undefined, state), 'exact'), lagged };
}

/** For each depth the largest distance between the ends of a piece in two poses, metres. */
export function apartByDepth(tree: PackedTree, a: Float32Array, b: Float32Array): number[] {
  const plane = planeOf(tree.restPose);
  const out = Array.from({ length: tree.depthStart.length - 1 }, () => 0);
  for (let i = 0; i < tree.pieceCount; i++) {
    const depth = depthOf(tree, i);
    const apart = distance(poseOf(a, plane, i).curve.p3, poseOf(b, plane, i).curve.p3);
    out[depth] = Math.max(out[depth] ?? 0, apart);
  }
  return out;
}
