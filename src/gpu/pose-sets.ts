import { DataTexture, FloatType, RGBAFormat, type Texture, type WebGLRenderTarget } from 'three';
import { POSE_TARGETS, TEXEL } from '../core/pack/layout.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import { floatTarget } from './float-target.ts';

/**
 * What a shader needs to read the pose: hand these very objects to a material, they stay the same while a tree lives.
 *
 * A piece of even depth is read from `poseEven`, one of odd depth from `poseOdd`; both hold the same textures where the
 * pass is lagged or the CPU poses the tree.
 */
export interface PoseUniforms {
  /** uniform sampler2D poseEven[4] */
  readonly poseEven: { value: Texture[] };
  /** uniform sampler2D poseOdd[4] */
  readonly poseOdd: { value: Texture[] };
}

const NAMES = Object.keys(POSE_TARGETS);
const COUNT = NAMES.length;

/** Where pieces stand: two sets of render targets for the pass, or one set of textures that the CPU writes. */
export interface PoseSets {
  /** Set 0 holds even depths, set 1 odd ones; null where the CPU poses the tree. */
  readonly targets: readonly [WebGLRenderTarget, WebGLRenderTarget] | null;
  /** The textures that the CPU writes; null where the GPU poses the tree. */
  readonly written: readonly DataTexture[] | null;
  readonly uniforms: PoseUniforms;
  dispose(): void;
}

/** Two sets of four RGBA32F targets of the tree's size; empty until they are seeded. */
export function targetSets(tree: PackedTree): PoseSets {
  const { width, height } = tree.restPose;
  const make = (name: string) =>
    floatTarget(
      width,
      height,
      NAMES.map((point) => `${name} ${point}`),
    );
  const targets = [make('pose even'), make('pose odd')] as const;
  return {
    targets,
    written: null,
    uniforms: { poseEven: { value: [...targets[0].textures] }, poseOdd: { value: [...targets[1].textures] } },
    dispose: () => {
      for (const target of targets) target.dispose();
    },
  };
}

/** Four textures over the memory that the CPU poses the tree in, which starts at rest; `data` is laid out as `restPose.data`. */
export function writtenSets(tree: PackedTree, data: Float32Array): PoseSets {
  const { width, height } = tree.restPose;
  const floats = width * height * TEXEL;
  const written = Array.from({ length: COUNT }, (_, i) => {
    const layer = data.subarray(i * floats, (i + 1) * floats) as Float32Array<ArrayBuffer>;
    const texture = new DataTexture(layer, width, height, RGBAFormat, FloatType);
    texture.needsUpdate = true;
    texture.name = `pose P${i}`;
    return texture;
  });
  return {
    targets: null,
    written,
    uniforms: { poseEven: { value: [...written] }, poseOdd: { value: [...written] } },
    dispose: () => {
      for (const texture of written) texture.dispose();
    },
  };
}
