import { WebGLRenderer } from 'three';
import { POSE_TARGETS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { capabilitiesOf, probePage } from '../../gpu/capabilities.ts';
import { readBack } from '../../gpu/read-back.ts';
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
      pass.update(renderer, time, wind);
      const shown = textures.uniforms.poseEven.value[0] === targets[0].textures[0] ? 0 : 1;
      const written = wind.pose === 'lagged' ? shown : null;
      const [even, odd] = await Promise.all([read(0), read(1)]);
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
