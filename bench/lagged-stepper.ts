import type { RawShaderMaterial, WebGLRenderer } from 'three';
import type { PackedTree } from '../src/core/pack/packed.ts';
import { createWindState } from '../src/core/wind/fade.ts';
import { PassState } from '../src/gpu/pass-state.ts';
import { TexelDraw, texelMaterial } from '../src/gpu/texel-draw.ts';
import { treeShader } from '../src/gpu/tree-shader.ts';
import { TreeTextures } from '../src/gpu/tree-textures.ts';
import { STEP } from '../src/gpu/wind-pass.ts';
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

  constructor(tree: PackedTree, fragment: string, defines: Record<string, number> = {}) {
    this.#textures = new TreeTextures(tree, true);
    this.#draw = new TexelDraw(tree.pieces.width, tree.pieces.height, [[0, tree.pieceCount]]);
    this.#parent = { value: this.#textures.pose.targets![0].textures };
    this.#material = texelMaterial(
      treeShader(fragment),
      {
        pieces: { value: this.#textures.pieces },
        parentPose: this.#parent,
        log2Width: { value: Math.log2(tree.pieces.width) },
        windWaves: { value: this.#wind.waves },
        windPhases: { value: this.#wind.phases },
        windExponents: { value: [1, 1] },
      },
      { WIND_WAVES: 4, ...defines },
    );
  }

  step(renderer: WebGLRenderer, source: WindSource): void {
    const step = ++this.#step;
    const targets = this.#textures.pose.targets!;
    source.fill(step * STEP, this.#wind);
    this.#wind.waves.fill(0, 4 * this.#wind.count);
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
