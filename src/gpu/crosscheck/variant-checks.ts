import { Vector3, Vector4, type WebGLRenderer } from 'three';
import branchVertex from '../../../shaders/debug/check-branch.vert';
import type { PackedTree } from '../../core/pack/packed.ts';
import { TreeTextures } from '../tree-textures.ts';
import { PARTS } from './compare.ts';
import { type Check, check } from './report.ts';
import { runVertices } from './run-vertices.ts';

/** Counts the shaders that this GPU's compiler refuses, from the call on; three prints nothing more of them. */
export function watchShaders(renderer: WebGLRenderer): { refused: string[] } {
  const refused: string[] = [];
  renderer.debug.onShaderError = (gl, program, vertex, fragment) => {
    const logs = [gl.getProgramInfoLog(program), gl.getShaderInfoLog(vertex), gl.getShaderInfoLog(fragment)];
    refused.push(logs.filter(Boolean).join(' ').trim());
  };
  return { refused };
}

/** The branch deformer's switches (shaders/branch/vertex.glsl); the fragment stages belong to three's materials. */
const SWITCHES = ['FLARED', 'PLAIN_STEM', 'RIBBON', 'PAPER_FORMS'];

/** Every combination of the branch deformer's switches: compiles, and gives numbers. */
export function checkVariants(renderer: WebGLRenderer, tree: PackedTree): Check {
  const watch = watchShaders(renderer);
  const textures = new TreeTextures(tree, false); // the rest pose, written by the CPU
  const position = new Float32Array([1, 0, 0, -1, 0, 0.5, -1, 0, 1, 1, 0, 1]);
  const normal = new Float32Array([0, 0, 0, 0.5, 0, 0, 0.5, 1, 0, 0, 1, 0]);
  const variants = 2 ** SWITCHES.length;
  let bad = 0;
  for (let bits = 0; bits < variants; bits++) {
    const defines = Object.fromEntries(SWITCHES.filter((_, i) => bits & (1 << i)).map((name) => [name, 1]));
    const results = runVertices(renderer, {
      vertexShader: branchVertex,
      defines,
      attributes: { position: { data: position, size: 3 }, normal: { data: normal, size: 3 } },
      uniforms: {
        ...textures.uniforms,
        poseLog2Width: { value: Math.log2(tree.restPose.width) },
        branchLog2Width: { value: Math.log2(tree.branches.width) },
        branchRange: { value: new Vector3(0, tree.pieceCount, tree.pieceCount) },
        stemShape: { value: [new Vector4(1, 0, 0, 0), new Vector4(0, 0, 0, 0.5)] },
      },
    });
    let normals = 0;
    for (let i = 0; i < 4; i++) normals += Math.hypot(...results.subarray(PARTS * i + 4, PARTS * i + 7));
    if (!(Math.abs(normals - 4) < 0.05)) bad++;
  }
  textures.dispose();
  const note = watch.refused[0]
    ? `of them the compiler says: ${watch.refused[0]}`
    : 'variants that do not compile or draw nothing';
  return check('branch deformer, variants', variants, Math.max(bad, watch.refused.length), 0, note);
}
