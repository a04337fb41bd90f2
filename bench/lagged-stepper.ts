import type { RawShaderMaterial, WebGLRenderer } from 'three';
import type { PackedTree } from '../src/core/pack/packed.ts';
import { createWindState } from '../src/core/wind/fade.ts';
import { forceDefines, forceUniforms } from '../src/core/wind/force-variant.ts';
import { PassState } from '../src/gpu/pass-state.ts';
import { STEP } from '../src/gpu/step.ts';
import { TexelDraw, texelMaterial } from '../src/gpu/texel-draw.ts';
import { treeShader } from '../src/gpu/tree-shader.ts';
import { TreeTextures } from '../src/gpu/tree-textures.ts';
import type { WindSource } from '../src/gpu/wind-source.ts';

/** All pieces of a tree at once, by any fragment shader with the inputs of the wind pass: to measure variants beside each other. */
export class LaggedStepper {
  readonly #textures: TreeTextures;
  readonly #material: RawShaderMaterial;
  readonly #draw: TexelDraw;
  readonly #state = new PassState();
  readonly #wind = createWindState();
  readonly #parent;
  #step = 0;

  /** The shader is the one that suits the wind as it is at time 0. */
  constructor(tree: PackedTree, fragment: string, source: WindSource, defines: Record<string, number> = {}) {
    source.fill(0, this.#wind);
    this.#textures = new TreeTextures(tree, true);
    this.#draw = new TexelDraw(tree.pieces.width, tree.pieces.height, [[0, tree.pieceCount]]);
    this.#parent = { value: this.#textures.pose.targets![0].textures };
    this.#material = texelMaterial(
      treeShader(fragment),
      {
        pieces: { value: this.#textures.pieces },
        parentPose: this.#parent,
        log2Width: { value: Math.log2(tree.pieces.width) },
        ...Object.fromEntries(Object.entries(forceUniforms(this.#wind)).map(([name, value]) => [name, { value }])),
        windExponents: { value: [this.#wind.forceExponent, this.#wind.lengthExponent] },
        windSoftness: { value: this.#wind.softness },
      },
      { ...forceDefines(this.#wind), ...defines },
    );
  }

  step(renderer: WebGLRenderer, source: WindSource): void {
    const step = ++this.#step;
    const targets = this.#textures.pose.targets!;
    source.fill(step * STEP, this.#wind);
    this.#parent.value = targets[step & 1].textures;
    this.#state.begin(renderer);
    this.#draw.draw(renderer, targets[1 - (step & 1)], this.#material, 0);
    this.#state.end(renderer);
  }

  /** Waits for the GPU: a read of one texel. */
  wait(renderer: WebGLRenderer, out: Float32Array): void {
    renderer.readRenderTargetPixels(this.#textures.pose.targets![0], 0, 0, 1, 1, out);
  }

  dispose(): void {
    this.#textures.dispose();
    this.#material.dispose();
    this.#draw.dispose();
  }
}
