import { TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { createWindState } from '../../core/wind/fade.ts';
import { poseTree } from '../../core/wind/pose-tree.ts';
import { STEP } from '../../gpu/step.ts';
import { depthOf } from './lag-run.ts';
import type { LivePose, TwoSets } from './live-pose.ts';

/** The same two sets, computed by the shader's twin in TypeScript. */
export function twinPose(tree: PackedTree): LivePose {
  const { data, width, height } = tree.restPose;
  const plane = TEXEL * width * height;
  const state = createWindState();
  return {
    by: 'twin',
    async run(time, wind): Promise<TwoSets> {
      const pose = (at: number, parents?: Float32Array): Float32Array => {
        wind.fill(at, state);
        return poseTree(tree, state, parents ? 'lagged' : 'exact', parents);
      };
      const sets: [Float32Array, Float32Array] = [data.slice(), data.slice()];
      if (wind.pose === 'lagged') {
        const wanted = Math.round(time / STEP);
        // A piece of depth d looks back d steps: before that nothing matters.
        for (let n = wanted - tree.depthStart.length; n <= wanted; n++) sets[n & 1] = pose(n * STEP, sets[1 - (n & 1)]);
        return { sets, written: (wanted & 1) as 0 | 1 };
      }
      const exact = pose(time);
      for (let piece = 0; piece < tree.pieceCount; piece++)
        for (let at = TEXEL * piece; at < exact.length; at += plane)
          sets[depthOf(tree, piece) & 1]?.set(exact.subarray(at, at + TEXEL), at);
      return { sets, written: null };
    },
    dispose() {},
  };
}
