import { distance } from '../../core/math/vec3.ts';
import { PIECE_LAYERS } from '../../core/pack/layout.ts';
import { layerStart, texelArray } from '../../core/pack/texel-array.ts';
import { bendWeights } from '../../core/wind/bend.ts';
import { createWindState, windStateAt } from '../../core/wind/fade.ts';
import { type PiecesToPose, planeOf, poseOf, poseTreePlainly } from '../../core/wind/pose-plainly.ts';
import { DEFAULT_GUST, type Gust, type Wind } from '../../core/wind/wind.ts';
import { windOf } from '../sum-of-sines/waves.ts';

/** Branches of a metre, each on the tip of the one before and turned to either side in turn; the lowest alone bends. */
export function chainOfBranches(levels: number): PiecesToPose {
  const pieces = texelArray(levels, 5);
  const restPose = texelArray(levels, 4);
  const put = (layer: number, i: number, texel: readonly number[]): void =>
    pieces.data.set(texel, layerStart(pieces, layer) + 4 * i);
  const third = 1 / 3;
  for (let i = 0; i < levels; i++) {
    // About the frame's own third axis, so that all stay in a plane.
    const half = (i % 2 === 0 ? 1 : -1) * 0.2;
    const up = [0, -Math.SQRT1_2, 0, Math.SQRT1_2];
    put(PIECE_LAYERS.ORIENT, i, i === 0 ? up : [0, Math.sin(half), 0, Math.cos(half)]);
    put(PIECE_LAYERS.ATTACH, i, [i - 1, 1, ...(i === 0 ? bendWeights(0, 1) : [0, 0])]);
    put(PIECE_LAYERS.HANDLE, i, [2 * third, 0, 0, third]);
    put(PIECE_LAYERS.END, i, [1, 0, 0, 1]);
    put(PIECE_LAYERS.TIP, i, [0, 0, 0, third]);
  }
  const tree: PiecesToPose = { pieceCount: levels, pieces, restPose };
  restPose.data.set(poseTreePlainly(tree, createWindState(), 'exact'));
  return tree;
}

/** A gust that is the same everywhere and has risen long ago. */
export const steadyGust = (push: number): Gust => ({
  ...DEFAULT_GUST,
  start: -1e4,
  amplitude: push,
  rise: 1,
  fall: 1e7,
  width: 0,
  speed: 1e6,
});

const steady = (push: number): Wind => windOf([], { gusts: [steadyGust(push)], lengthExponent: 0 });

export interface Impulse {
  readonly tree: PiecesToPose;
  /** Where all should be. */
  readonly exact: Float32Array;
  /** The pose after each step, from step 0 on; before it all is at rest. */
  readonly steps: readonly Float32Array[];
}

/** The lowest branch is bent at step 0 and stays so: what the paper's step, run `count` times, makes of the rest. */
export function impulse(levels: number, push: number, count: number): Impulse {
  const tree = chainOfBranches(levels);
  const wind = windStateAt(steady(push), 0);
  const steps: Float32Array[] = [];
  let previous: Float32Array = tree.restPose.data;
  for (let n = 0; n < count; n++) {
    previous = poseTreePlainly(tree, wind, 'lagged', previous);
    steps.push(previous);
  }
  return { tree, exact: poseTreePlainly(tree, wind, 'exact'), steps };
}

/** How far each branch's end is from where it should be, metres. */
export const errorsOf = ({ tree, exact }: Impulse, pose: Float32Array): number[] => {
  const plane = planeOf(tree.restPose);
  return Array.from({ length: tree.pieceCount }, (_, i) =>
    distance(poseOf(pose, plane, i).curve.p3, poseOf(exact, plane, i).curve.p3),
  );
};
