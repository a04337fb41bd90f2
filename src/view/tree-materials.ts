import {
  DoubleSide,
  FrontSide,
  type IUniform,
  type Mesh,
  MeshDepthMaterial,
  MeshDistanceMaterial,
  MeshStandardMaterial,
} from 'three';
import { BRANCH_DEPTH, BRANCH_STANDARD } from './branch-shader.ts';
import { inject } from './inject.ts';
import { LEAF_DEPTH, LEAF_STANDARD } from './leaf-shader.ts';

/** A mesh's material with the two that draw it into shadow maps. */
export interface MaterialSet {
  readonly standard: MeshStandardMaterial;
  readonly depth: MeshDepthMaterial;
  readonly distance: MeshDistanceMaterial;
}

/**
 * Materials for stems. `defines`: RIBBON, PLAIN_STEM (a cone: no flare, lobes or bulges, taper <= 1), FLARED (rings crowd towards
 * the ground), PAPER_FORMS (the paper's frames and sections, for teaching).
 */
export function branchMaterials(defines: readonly string[], uniforms: Record<string, IUniform>): MaterialSet {
  const key = `windgrove branch ${defines.join(' ')}`;
  const standard = new MeshStandardMaterial({ metalness: 0, side: FrontSide });
  const depth = new MeshDepthMaterial();
  const distance = new MeshDistanceMaterial();
  // A ribbon turns its front to the light as it does to the eye; three draws back faces into the shadow map.
  if (defines.includes('RIBBON')) standard.shadowSide = DoubleSide;
  for (const material of [standard, depth, distance]) {
    material.defines = { ...material.defines, ...Object.fromEntries(defines.map((name) => [name, ''])) };
    inject(material, key, material === standard ? BRANCH_STANDARD : BRANCH_DEPTH, uniforms);
  }
  return { standard, depth, distance };
}

/** Materials for leaves and organs. `defines`: LEAF_NEAR, LEAF_VEINS, LEAF_ORGAN, LEAF_LIT, LEAF_LISTED (in the picture alone). `cast`: uniforms that are others in shadow maps. */
export function leafMaterials(
  defines: readonly string[],
  uniforms: Record<string, IUniform>,
  cast: Record<string, IUniform> = {},
): MaterialSet {
  const key = `windgrove leaf ${defines.join(' ')}`;
  const standard = new MeshStandardMaterial({ metalness: 0, side: DoubleSide });
  const depth = new MeshDepthMaterial({ side: DoubleSide });
  const distance = new MeshDistanceMaterial({ side: DoubleSide });
  for (const material of [standard, depth, distance]) {
    // What the eye does not see casts shadows all the same.
    const own = material === standard ? defines : defines.filter((name) => name !== 'LEAF_LISTED');
    material.defines = { ...material.defines, ...Object.fromEntries(own.map((name) => [name, ''])) };
    if (material === standard) inject(material, key, LEAF_STANDARD, uniforms);
    else inject(material, key, LEAF_DEPTH, { ...uniforms, ...cast });
  }
  return { standard, depth, distance };
}

/** Draws a mesh, and its shadow, with a set. */
export function dress(mesh: Mesh, set: MaterialSet): void {
  mesh.material = set.standard;
  mesh.customDepthMaterial = set.depth;
  mesh.customDistanceMaterial = set.distance;
}

/** Frees the programs of a set. */
export function disposeMaterials(set: MaterialSet): void {
  set.standard.dispose();
  set.depth.dispose();
  set.distance.dispose();
}
