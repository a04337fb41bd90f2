import { bonedTree } from '../../mesh/boned-tree.ts';
import { type JointClip, reduceClip } from '../../mesh/joint-clip.ts';
import { placeJoints, type Skeleton } from '../../mesh/skeleton.ts';
import type { GrownPacked } from '../../pack/grow-packed.ts';
import { LoopedPoses } from '../../wind/looped-poses.ts';
import { planeOf } from '../../wind/pose-plainly.ts';
import type { Wind } from '../../wind/wind.ts';
import type { ExportOptions } from '../export-options.ts';
import { yUpJoints } from './y-up.ts';

/** How far the keys may put a joint from its sample: radians, metres. */
export const CLIP_ANGLE = 4e-4;
export const CLIP_DISTANCE = 4e-4;

/** A clip, and what its wind had to become for it to come around. */
export interface BakedClip {
  readonly clip: JointClip;
  readonly poses: LoopedPoses;
}

/** Frames of a clip: at least one, so many a second. */
export const clipFrames = ({ seconds, rate }: Pick<ExportOptions, 'seconds' | 'rate'>): number =>
  Math.max(2, Math.round(seconds * rate));

/** Samples the reference's poses of a tree in a wind, once around, as keys of its skeleton (y up). `rest`: the joints at rest, y up. */
export function bakeClip(
  { packed, pieces }: GrownPacked,
  skeleton: Skeleton,
  rest: Float64Array,
  wind: Wind,
  options: Pick<ExportOptions, 'boneLevels' | 'start' | 'seconds' | 'rate'>,
  report: (done: number) => void,
): BakedClip {
  const { tree, at } = bonedTree(packed, pieces, options.boneLevels);
  const poses = new LoopedPoses(tree, wind, options.start, options.seconds);
  report(0.4);
  const count = clipFrames(options);
  const plane = planeOf(tree.restPose);
  const pose = new Float32Array(tree.restPose.data.length);
  const frames: Float64Array[] = [];
  for (let f = 0; f < count; f++) {
    poses.at((f / count) * options.seconds, pose);
    frames.push(yUpJoints(placeJoints(skeleton, pose, plane, undefined, (piece) => at[piece]!)));
    if ((f & 15) === 0) report(0.4 + (0.4 * f) / count);
  }
  frames.push(frames[0]!);
  const clip = reduceClip(skeleton, rest, frames, options.seconds, CLIP_ANGLE, CLIP_DISTANCE, (done) =>
    report(0.8 + 0.2 * done),
  );
  return { clip, poses };
}
