import { type Accessor, AnimationChannel, AnimationSampler, type Document, type Node } from '@gltf-transform/core';
import type { JointClip, JointKeys } from '../../mesh/joint-clip.ts';
import type { Accessors } from './accessors.ts';

/** A clip as an animation: a channel for each joint and way in which it moves. Equal times are stored once. */
export function clipTracks(
  document: Document,
  accessors: Accessors,
  clip: JointClip,
  joints: readonly Node[],
  name: string,
  extras: Record<string, unknown>,
): void {
  const animation = document.createAnimation(name).setExtras(extras);
  const known = new Map<string, Accessor>();
  const timesOf = (times: Float32Array): Accessor => {
    const key = new Uint32Array(times.buffer, times.byteOffset, times.length).join();
    const found = known.get(key) ?? accessors.add(times, 1);
    known.set(key, found);
    return found;
  };
  const add = (node: Node, path: 'rotation' | 'translation', keys: JointKeys): void => {
    const sampler = document
      .createAnimationSampler()
      .setInterpolation(AnimationSampler.Interpolation.LINEAR)
      .setInput(timesOf(keys.times))
      .setOutput(accessors.add(keys.values, path === 'rotation' ? 4 : 3));
    const channel = document
      .createAnimationChannel()
      .setTargetNode(node)
      .setTargetPath(AnimationChannel.TargetPath[path === 'rotation' ? 'ROTATION' : 'TRANSLATION'])
      .setSampler(sampler);
    animation.addSampler(sampler).addChannel(channel);
  };
  if (clip.keys === 0 && joints[0]) {
    // A clip of still air is one all the same, and as long as was asked for.
    const turn = joints[0].getRotation();
    add(joints[0], 'rotation', {
      times: Float32Array.of(0, clip.seconds),
      values: Float32Array.from([...turn, ...turn]),
    });
  }
  clip.joints.forEach(({ rotation, translation }, j) => {
    if (rotation) add(joints[j]!, 'rotation', rotation);
    if (translation) add(joints[j]!, 'translation', translation);
  });
}
