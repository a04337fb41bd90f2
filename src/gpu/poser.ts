import type { WebGLRenderer } from 'three';
import type { WindSource } from './wind-source.ts';

/** What keeps the pose textures of a tree up to date: the wind pass on the GPU, or the reference on the CPU. */
export interface Poser {
  /** Poses the tree as of `time` seconds; leaves every setting of `renderer` as it was. */
  update(renderer: WebGLRenderer, time: number, source: WindSource): void;
  /** The pose as last computed, laid out as `PackedTree.restPose.data`; slow: for checks and exports. */
  read(renderer: WebGLRenderer, out?: Float32Array): Float32Array;
  dispose(): void;
}
