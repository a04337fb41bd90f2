import { WebGLRenderer } from 'three';
import { POSE_TARGETS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { capabilitiesOf, probePage } from '../../gpu/capabilities.ts';
import { readBack } from '../../gpu/read-back.ts';
import { STEP } from '../../gpu/step.ts';
import { TreeTextures } from '../../gpu/tree-textures.ts';
import { WindPass } from '../../gpu/wind-pass.ts';
import type { LivePose, TwoSets } from './live-pose.ts';

const LAYERS = Object.keys(POSE_TARGETS).length;

/** The wind pass of every tree of Windgrove, on a context of its own that draws no picture; null where none is given or it draws into no float textures. `restored`: a lost context is back. */
export function shaderPose(tree: PackedTree, restored: () => void): LivePose | null {
  if (!probePage().floatTargets) return null;
  const renderer = new WebGLRenderer({ canvas: document.createElement('canvas'), antialias: false, depth: false });
  const textures = new TreeTextures(tree, capabilitiesOf(renderer).floatTargets);
  const { targets } = textures.pose;
  if (!targets) {
    textures.dispose();
    renderer.dispose();
    return null;
  }
  const pass = new WindPass(textures);
  renderer.domElement.addEventListener('webglcontextrestored', restored);
  const read = (set: 0 | 1) =>
    readBack(renderer, targets[set], LAYERS, [0, 0, tree.restPose.width, tree.restPose.height]);
  return {
    by: 'shader',
    async run(time, wind): Promise<TwoSets | null> {
      const lagged = wind.pose === 'lagged';
      // Of the step before the pass needs the parents alone, and its deepest pieces may be of any pose: here they are seen.
      if (lagged) pass.update(renderer, time - STEP, wind);
      pass.update(renderer, time, wind);
      const shown = textures.uniforms.poseEven.value[0] === targets[0].textures[0] ? 0 : 1;
      // Into which of the two a step goes depends on how many the pass has run; shown by the step's own number it is always the same picture.
      const written = lagged ? ((Math.round(time / STEP) & 1) as 0 | 1) : null;
      const first = written === null || written === shown ? 0 : 1;
      const [even, odd] = await Promise.all([read(first), read(first === 0 ? 1 : 0)]);
      return even && odd && { sets: [even, odd], written };
    },
    dispose() {
      pass.dispose();
      textures.dispose();
      renderer.forceContextLoss();
      renderer.dispose();
    },
  };
}
