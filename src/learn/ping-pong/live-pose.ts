import { TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { WindSource } from '../../gpu/wind-source.ts';
import { depthOf } from './lag-run.ts';

/** The two sets of pose textures after an update, each laid out as `PackedTree.restPose.data`. */
export interface TwoSets {
  readonly sets: readonly [Float32Array, Float32Array];
  /** The set that the last step wrote where the pose lags; null where even depths are in the first set, odd ones in the second. */
  readonly written: 0 | 1 | null;
}

/** What poses the tree of a figure, and lets its textures be looked at. */
export interface LivePose {
  /** Whose numbers these are. */
  readonly by: 'shader' | 'twin';
  /** Poses the tree as of `time` seconds and brings the textures, some frames later; null where the context was lost meanwhile. */
  run(time: number, wind: WindSource): Promise<TwoSets | null>;
  dispose(): void;
}

/** The set in which the deformer finds a piece. */
export const setOf = (tree: PackedTree, { written }: TwoSets, piece: number): 0 | 1 =>
  written ?? ((depthOf(tree, piece) & 1) as 0 | 1);

/** The pose that the deformer reads, out of both sets. */
export function poseIn(tree: PackedTree, two: TwoSets): Float32Array {
  if (two.written !== null) return two.sets[two.written];
  const out = two.sets[0].slice();
  const plane = TEXEL * tree.restPose.width * tree.restPose.height;
  for (let piece = 0; piece < tree.pieceCount; piece++) {
    if (setOf(tree, two, piece) === 0) continue;
    for (let at = TEXEL * piece; at < out.length; at += plane) out.set(two.sets[1].subarray(at, at + TEXEL), at);
  }
  return out;
}
