import type { WebGLRenderer } from 'three';
import { createWindState } from '../core/wind/fade.ts';
import { poseTree } from '../core/wind/pose-tree.ts';
import type { Poser } from './poser.ts';
import type { TreeTextures } from './tree-textures.ts';
import type { WindSource } from './wind-source.ts';

/** Poses a tree by the TypeScript reference and uploads the pose: where the GPU draws into no float textures. Always `exact`. */
export class CpuPoser implements Poser {
  readonly #textures: TreeTextures;
  readonly #pose: Float32Array;
  readonly #wind = createWindState();
  #time = Number.NaN;
  #revision = Number.NaN;

  /** `textures` must be made for the CPU (`gpuPose` false). */
  constructor(textures: TreeTextures) {
    if (!textures.cpuPose) throw new Error('CpuPoser needs textures that the CPU writes.');
    this.#textures = textures;
    this.#pose = textures.cpuPose;
  }

  update(_renderer: WebGLRenderer, time: number, source: WindSource): void {
    if (time === this.#time && source.revision === this.#revision) return;
    source.fill(time, this.#wind);
    poseTree(this.#textures.tree, this.#wind, 'exact', undefined, this.#pose);
    for (const texture of this.#textures.pose.written ?? []) texture.needsUpdate = true;
    this.#time = time;
    this.#revision = source.revision;
  }

  read(_renderer: WebGLRenderer, out = new Float32Array(this.#pose.length)): Float32Array {
    out.set(this.#pose);
    return out;
  }

  dispose(): void {}
}
