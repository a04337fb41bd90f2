import type { WebGLRenderer } from 'three';
import type { PackedTree } from '../core/pack/packed.ts';
import { type Capabilities, capabilitiesOf } from './capabilities.ts';
import { CpuPoser } from './cpu-poser.ts';
import { TreeTextures } from './tree-textures.ts';
import { WindPass } from './wind-pass.ts';
import type { WindSource } from './wind-source.ts';

/** What keeps the pose textures of a tree up to date: the wind pass on the GPU, or the reference on the CPU. */
export interface Poser {
  /** Poses the tree as of `time` seconds; leaves every setting of `renderer` as it was. */
  update(renderer: WebGLRenderer, time: number, source: WindSource): void;
  /** The pose as last computed, laid out as `PackedTree.restPose.data`; slow: for checks and exports. */
  read(renderer: WebGLRenderer, out?: Float32Array): Float32Array;
  dispose(): void;
}

/** A tree on the GPU and what poses it. */
export interface PosedTree {
  readonly textures: TreeTextures;
  readonly poser: Poser;
  dispose(): void;
}

/** The textures of a tree and the best poser for this renderer; `capabilities` may be given to try a lesser one. */
export function createPosedTree(
  renderer: WebGLRenderer,
  tree: PackedTree,
  capabilities: Pick<Capabilities, 'floatTargets'> = capabilitiesOf(renderer),
): PosedTree {
  const textures = new TreeTextures(tree, capabilities.floatTargets);
  const poser = capabilities.floatTargets ? new WindPass(textures) : new CpuPoser(textures);
  return {
    textures,
    poser,
    dispose: () => {
      poser.dispose();
      textures.dispose();
    },
  };
}
