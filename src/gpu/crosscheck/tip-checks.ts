import type { WebGLRenderer } from 'three';
import { POSE_TARGETS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { STEP } from '../step.ts';
import { galeOf } from './check-winds.ts';
import { passOf } from './pass-checks.ts';
import { type Check, check } from './report.ts';
import { EditedWind } from './state-checks.ts';

/** So short before a step is looked as well: a motion goes nearly no way in it, a pop does. */
const MOMENT = STEP / 30;

const FRAMES = 180;

/** Frames at which another model fades in. */
const SWITCHES = new Map([
  [40, galeOf('direct')],
  [80, galeOf('spring')],
  [120, galeOf('sway')],
]);

/**
 * Tips of what the GPU draws through three seconds of a gale in which models are switched: none may go farther around a step than its
 * speed in the frame before says, twice over.
 */
export function checkTips(renderer: WebGLRenderer, tree: PackedTree): Check {
  const { pass, dispose } = passOf(tree);
  const source = new EditedWind(galeOf('spring'));
  const end = layerStart(tree.restPose, POSE_TARGETS.P3);
  const tips = (time: number): Float32Array => {
    pass.update(renderer, time, source);
    return pass.read(renderer).slice(end, end + 4 * tree.pieceCount);
  };
  const apart = (a: Float32Array, b: Float32Array, i: number): number =>
    Math.hypot(a[i] - b[i], a[i + 1] - b[i + 1], a[i + 2] - b[i + 2]);
  let leap = 0;
  let moved = 0;
  let last = tips(0);
  for (let frame = 1; frame <= FRAMES; frame++) {
    const time = frame * STEP;
    const before = tips(time - MOMENT);
    const wind = SWITCHES.get(frame);
    if (wind) source.set(wind, time - MOMENT, 0.4);
    const now = tips(time);
    for (let i = 0; i < before.length; i += 4) {
      const way = apart(before, last, i);
      moved = Math.max(moved, way);
      leap = Math.max(leap, apart(now, before, i) - (2 * way * MOMENT) / (STEP - MOMENT));
    }
    last = now;
  }
  dispose();
  const height = tree.bounds[5] - tree.bounds[2];
  const note = 'of the tree’s height, around a step and while models are switched';
  return check('wind pass, no tip leaps', moved > 0.001 * height ? FRAMES : 0, leap / height, 2e-4, note);
}
