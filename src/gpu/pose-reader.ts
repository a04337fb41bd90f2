import type { Texture, WebGLRenderer, WebGLRenderTarget } from 'three';
import { POSE_TARGETS, STATE_TARGETS, TEXEL } from '../core/pack/layout.ts';
import type { ReadBack } from './poser.ts';
import { readBack } from './read-back.ts';
import type { TreeTextures } from './tree-textures.ts';

const POSES = Object.keys(POSE_TARGETS).length;
const STATES = Object.keys(STATE_TARGETS).length;

/** Reads what the GPU has made of a tree: at once, which waits for it, or without waiting. */
export class PoseReader {
  readonly #textures: TreeTextures;
  readonly #targets: readonly [WebGLRenderTarget, WebGLRenderTarget];

  constructor(textures: TreeTextures, targets: readonly [WebGLRenderTarget, WebGLRenderTarget]) {
    this.#textures = textures;
    this.#targets = targets;
  }

  /** The pose, laid out as `PackedTree.restPose.data`. */
  read(renderer: WebGLRenderer, out: Float32Array): Float32Array {
    const [even, odd] = this.#sets();
    readAll(renderer, even, out);
    if (odd === even) return out;
    const other = new Float32Array(out.length);
    readAll(renderer, odd, other);
    return this.#merge(out, other);
  }

  /** A state of the springs, target by target as STATE_TARGETS says. */
  readState(renderer: WebGLRenderer, set: WebGLRenderTarget): Float32Array {
    return readAll(renderer, set, new Float32Array(STATES * TEXEL * set.width * set.height), STATES);
  }

  /** Both of this moment, some frames later; null where the context was lost meanwhile. */
  async readBack(renderer: WebGLRenderer, state: WebGLRenderTarget | null): Promise<ReadBack | null> {
    const [even, odd] = this.#sets();
    const window = [0, 0, even.width, even.height] as const;
    const [pose, other, springs] = await Promise.all([
      readBack(renderer, even, POSES, window),
      odd === even ? null : readBack(renderer, odd, POSES, window),
      state && readBack(renderer, state, STATES, window),
    ]);
    if (!pose || (odd !== even && !other) || (state && !springs)) return null;
    return { pose: other ? this.#merge(pose, other) : pose, state: springs };
  }

  /** The pose of one piece, 4 numbers of each target. */
  async readPiece(renderer: WebGLRenderer, piece: number): Promise<Float32Array | null> {
    const { pieceCount, depthStart, restPose } = this.#textures.tree;
    if (!(Number.isInteger(piece) && piece >= 0 && piece < pieceCount)) return null;
    const depth = depthStart.findIndex((start) => start > piece) - 1;
    const target = this.#sets()[depth & 1];
    const { width } = restPose;
    return readBack(renderer, target, POSES, [piece % width, Math.floor(piece / width), 1, 1]);
  }

  /** The sets that even and odd depths are shown from. */
  #sets(): [WebGLRenderTarget, WebGLRenderTarget] {
    const { poseEven, poseOdd } = this.#textures.uniforms;
    const set = ([first]: Texture[]) => this.#targets[first === this.#targets[0].textures[0] ? 0 : 1];
    return [set(poseEven.value), set(poseOdd.value)];
  }

  /** Puts the odd depths of `other` into `pose`. */
  #merge(pose: Float32Array, other: Float32Array): Float32Array {
    const { depthStart } = this.#textures.tree;
    const plane = pose.length / POSES;
    for (let depth = 1; depth + 1 < depthStart.length; depth += 2) {
      for (let target = 0; target < POSES; target++) {
        const [start, end] = [depthStart[depth], depthStart[depth + 1]].map((i) => target * plane + TEXEL * i);
        pose.set(other.subarray(start, end), start);
      }
    }
    return pose;
  }
}

function readAll(renderer: WebGLRenderer, set: WebGLRenderTarget, out: Float32Array, layers = POSES): Float32Array {
  const { width, height } = set;
  const floats = TEXEL * width * height;
  for (let i = 0; i < layers; i++) {
    const layer = out.subarray(i * floats, (i + 1) * floats);
    renderer.readRenderTargetPixels(set, 0, 0, width, height, layer, undefined, i);
  }
  return out;
}
