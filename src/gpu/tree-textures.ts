import { DataArrayTexture, FloatType, RGBAFormat, RGBAIntegerFormat, UnsignedIntType } from 'three';
import type { PackedTree, TexelArray } from '../core/pack/packed.ts';
import { type PoseSets, type PoseUniforms, targetSets, writtenSets } from './pose-sets.ts';

/** A texel array as a texture: RGBA32F or RGBA32UI as its numbers are, nearest, no copy of the data. */
export function arrayTexture(texels: TexelArray | TexelArray<Uint32Array>, name: string): DataArrayTexture {
  const data = texels.data as Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;
  const texture = new DataArrayTexture(data, texels.width, texels.height, texels.layers);
  const words = data instanceof Uint32Array;
  texture.format = words ? RGBAIntegerFormat : RGBAFormat;
  texture.type = words ? UnsignedIntType : FloatType; // the filters of a data texture are nearest already
  if (words) texture.internalFormat = 'RGBA32UI';
  texture.name = name;
  texture.needsUpdate = true;
  return texture;
}

/** What the deformers read besides the pose; the objects stay the same while a tree lives. */
export interface TreeUniforms extends PoseUniforms {
  /** uniform sampler2DArray branches: layers of BRANCH_LAYERS */
  readonly branches: { value: DataArrayTexture };
  /** uniform usampler2DArray leaves: layers of LEAF_LAYERS */
  readonly leaves: { value: DataArrayTexture };
}

/** Every texture of one tree on the GPU; three uploads each at its first use, and again after a lost context. */
export class TreeTextures {
  #tree: PackedTree;
  readonly pieces: DataArrayTexture;
  readonly branches: DataArrayTexture;
  readonly leaves: DataArrayTexture;
  readonly pose: PoseSets;
  readonly uniforms: TreeUniforms;
  /** The pose that the CPU writes, laid out as `restPose.data`; null where the GPU poses the tree. */
  readonly cpuPose: Float32Array | null;

  /** `gpuPose`: four float targets can be drawn into (`Capabilities.floatTargets`); else the CPU poses the tree. */
  constructor(tree: PackedTree, gpuPose: boolean) {
    this.#tree = tree;
    this.pieces = arrayTexture(tree.pieces, 'pieces');
    this.branches = arrayTexture(tree.branches, 'branches');
    this.leaves = arrayTexture(tree.leaves, 'leaves');
    this.cpuPose = gpuPose ? null : tree.restPose.data.slice();
    this.pose = this.cpuPose ? writtenSets(tree, this.cpuPose) : targetSets(tree);
    this.uniforms = { ...this.pose.uniforms, branches: { value: this.branches }, leaves: { value: this.leaves } };
  }

  get tree(): PackedTree {
    return this.#tree;
  }

  /** Holds another tree from now on, in the same textures; false where that is of another size. What has posed the former poses it no more. */
  retake(tree: PackedTree): boolean {
    const former = this.#tree;
    const parts = ['pieces', 'branches', 'leaves', 'restPose'] as const;
    const alike = parts.every((part) =>
      (['width', 'height', 'layers'] as const).every((side) => tree[part][side] === former[part][side]),
    );
    if (!alike) return false;
    this.#tree = tree;
    for (const part of ['pieces', 'branches', 'leaves'] as const) {
      this[part].image.data = tree[part].data as Float32Array<ArrayBuffer>;
      this[part].needsUpdate = true;
    }
    this.cpuPose?.set(tree.restPose.data);
    return true;
  }

  /** Bytes that the tree takes on the GPU. */
  get bytes(): number {
    const { pieces, restPose, branches, leaves } = this.tree;
    const texels = [pieces, branches, leaves].reduce((sum, array) => sum + array.data.byteLength, 0);
    return texels + restPose.data.byteLength * (this.cpuPose ? 1 : 2);
  }

  dispose(): void {
    this.pieces.dispose();
    this.branches.dispose();
    this.leaves.dispose();
    this.pose.dispose();
  }
}
