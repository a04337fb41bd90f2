import type { WebGLRenderer } from 'three';
import type { WindSource } from './wind-source.ts';

/** What a tree's textures hold at one moment. */
export interface ReadBack {
  /** Laid out as `PackedTree.restPose.data`. */
  readonly pose: Float32Array;
  /** The springs' state that the pose comes from (at a time between two steps: that of the first), one target of STATE_TARGETS after the other; null without springs. */
  readonly state: Float32Array | null;
}

/** What keeps the pose textures of a tree up to date: the wind pass on the GPU, or the reference on the CPU. */
export interface Poser {
  /** Part (0..1) of the steps to the time of the last update that are made; null: the pose is of that time. */
  readonly catchingUp: number | null;
  /** Bytes on the GPU besides the tree's textures. */
  readonly bytes: number;
  /** What began with the wind of its first time, instead of at time 0, is computed anew by the next update. */
  settle(): void;
  /** Poses the tree as of `time` seconds, or makes some of the steps to it; leaves every setting of `renderer` as it was. */
  update(renderer: WebGLRenderer, time: number, source: WindSource): void;
  /** The pose as last computed, laid out as `PackedTree.restPose.data`; slow: for checks and exports. */
  read(renderer: WebGLRenderer, out?: Float32Array): Float32Array;
  /** The state of `ReadBack`; slow: for checks. */
  readState(renderer: WebGLRenderer): Float32Array | null;
  /** Pose and state of now, without waiting for the GPU: there some frames later. null where the context was lost meanwhile. */
  readBack(renderer: WebGLRenderer): Promise<ReadBack | null>;
  /** The 16 numbers of a piece's pose, P0 to P3, of now, likewise; null where there is no such piece, too. */
  readPiece(renderer: WebGLRenderer, piece: number): Promise<Float32Array | null>;
  dispose(): void;
}
