import type { Material, Mesh, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three';
import { patched } from '../inject.ts';

const done = new WeakSet<Material>();

/** What a bake writes in place of light: colour before light, and normal in the frame of the view, depth, light of the sky. */
const output = (sky: string): string => `gl_FragColor = vec4(diffuseColor.rgb, 1.0);
bakedShape = vec4(0.5 + 0.5 * normal.xy, gl_FragCoord.z, ${sky});`;

/** Makes the material of a part of a tree write what an impostor needs, into two targets; once a material. */
export function bakeMaterial({ material, name }: Mesh): void {
  if (Array.isArray(material) || done.has(material)) return;
  done.add(material);
  // The colour and the normal of each pixel are written, which leaves that are lit at their corners do not have.
  const { LEAF_LIT: _, ...defines } = material.defines ?? {};
  material.defines = defines;
  const sky = name.startsWith('level') ? 'barkAmbient()' : 'vLeaf.y';
  const compile = material.onBeforeCompile;
  const key = material.customProgramCacheKey();
  material.onBeforeCompile = (shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer) => {
    compile.call(material, shader, renderer);
    shader.fragmentShader = patched(shader.fragmentShader, [
      { anchor: '#include <common>', before: 'layout(location = 1) out highp vec4 bakedShape;' },
      { anchor: '#include <dithering_fragment>', after: output(sky) },
    ]);
  };
  material.customProgramCacheKey = () => `${key} baked ${sky}`;
}
