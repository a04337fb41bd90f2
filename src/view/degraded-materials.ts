import { type IUniform, MeshDepthMaterial, MeshDistanceMaterial, MeshStandardMaterial } from 'three';
import { BRANCH_LINE, LEAF_POINT, LEAF_POINT_DEPTH } from './degraded-shader.ts';
import { inject } from './inject.ts';
import type { MaterialSet } from './tree-materials.ts';

const named = (defines: readonly string[]): Record<string, string> =>
  Object.fromEntries(defines.map((name) => [name, '']));

/** A material for lines along stems; `defines` as for ribbons. */
export function lineMaterial(
  defines: readonly string[],
  uniforms: Record<string, IUniform>,
  roughness: number,
): MeshStandardMaterial {
  const material = new MeshStandardMaterial({ metalness: 0, roughness });
  material.defines = { ...material.defines, ...named(defines) };
  inject(material, `windgrove line ${defines.join(' ')}`, BRANCH_LINE, uniforms);
  return material;
}

/** Materials for leaves as points; `shadowScale` is half the texels a side of the shadow map. */
export function pointMaterials(
  defines: readonly string[],
  uniforms: Record<string, IUniform>,
  shadowScale: IUniform,
  roughness: number,
): MaterialSet {
  const key = `windgrove point ${defines.join(' ')}`;
  const standard = new MeshStandardMaterial({ metalness: 0, roughness });
  const depth = new MeshDepthMaterial();
  const distance = new MeshDistanceMaterial();
  for (const material of [standard, depth, distance]) {
    material.defines = { ...material.defines, ...named(defines) };
    const own = material === standard ? uniforms : { ...uniforms, pointScale: shadowScale };
    inject(material, key, material === standard ? LEAF_POINT : LEAF_POINT_DEPTH, own);
  }
  return { standard, depth, distance };
}
