import { Box3, Mesh, Vector3 } from 'three';
import { barkImage } from '../core/look/bark-image.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import { TreeTextures } from '../gpu/tree-textures.ts';
import { barkTexture } from './bark-texture.ts';
import { branchGeometry } from './branch-geometry.ts';
import type { GridSpec } from './grid.ts';
import { STREWN_HALF } from './strewn-pieces.ts';
import { branchMaterials } from './tree-materials.ts';
import { barkUniforms, levelUniforms, sharedUniforms } from './uniforms.ts';

/** The taper of what is timed. */
export const STREWN_TAPER = 1;

/** Around the strewn pieces. */
export const STREWN_BOX = new Box3(new Vector3().setScalar(-STREWN_HALF - 2), new Vector3().setScalar(STREWN_HALF + 2));

/** One bark for what is timed: textured, in relief. */
export function strewnBark() {
  const uniforms = barkUniforms();
  uniforms.barkMap.value = barkTexture('plated', { barkImage });
  uniforms.barkTile.value.x = 0.7;
  uniforms.barkColour.value.set('#8a7a68');
  uniforms.barkDark.value.set('#3a3028');
  uniforms.barkRelief.value = 0.6;
  return uniforms;
}

/** Strewn pieces bent on the GPU, as a tree does it, with one grid for all. Its textures go with the context; the caller disposes of its geometry. */
export function deformedMesh(tree: PackedTree, spec: GridSpec): Mesh {
  const textures = new TreeTextures(tree, false);
  const shared = sharedUniforms();
  shared.poseEven.value = textures.uniforms.poseEven.value;
  shared.poseOdd.value = textures.uniforms.poseOdd.value;
  shared.poseLog2Width.value = Math.log2(tree.restPose.width);
  shared.branches.value = textures.branches;
  shared.branchLog2Width.value = Math.log2(tree.branches.width);
  shared.crownRadii.value.setScalar(STREWN_HALF);
  const level = levelUniforms();
  level.branchRange.value.set(0, tree.pieceCount, spec.bundle);
  level.stemShape.value[0].set(STREWN_TAPER, 0, 0, 0);
  const { standard } = branchMaterials(['PLAIN_STEM'], { ...shared, ...strewnBark(), ...level });
  return new Mesh(branchGeometry(spec, tree.pieceCount, STREWN_BOX), standard);
}
