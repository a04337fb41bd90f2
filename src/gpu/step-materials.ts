import { Camera, type IUniform, Mesh, type RawShaderMaterial, type WebGLRenderer } from 'three';
import seedFragment from '../../shaders/wind/seed.frag';
import stepFragment from '../../shaders/wind/step.frag';
import { createWindState, type WindState } from '../core/wind/fade.ts';
import { texelMaterial } from './texel-draw.ts';
import { treeShader } from './tree-shader.ts';

/** Waves that the usual variant sums; a fade needs twice as many. */
const FEW = 4;

/**
 * The variants of the step's shader for one renderer, shared by all trees: another tree must not compile them again.
 *
 * A pass sets the values of the uniforms before each draw; three sends them with every draw into another target.
 */
export class StepMaterials {
  readonly wind: WindState = createWindState();
  readonly uniforms: Record<'pieces' | 'parentPose' | 'log2Width' | 'windExponents', IUniform> = {
    pieces: { value: null },
    parentPose: { value: null },
    log2Width: { value: 0 },
    windExponents: { value: [1, 1] },
  };
  /** Writes the rest pose; set `uniforms.restPose.value` first. */
  readonly seed = texelMaterial(seedFragment, { restPose: { value: null } });
  /** By forms and number of waves. Found without a name: one is asked for at every draw. */
  readonly #variants: RawShaderMaterial[] = [];
  #warm = false;

  /** The shader for `this.wind`, whose values are set: with the printed forms or without, for four waves or for eight. */
  material(renderer: WebGLRenderer): RawShaderMaterial {
    const { wind, uniforms } = this;
    // The shader sums every slot: those not in use must push nothing.
    wind.waves.fill(0, 4 * wind.count);
    uniforms.windExponents.value[0] = wind.forceExponent;
    uniforms.windExponents.value[1] = wind.lengthExponent;
    const material = this.#variant(wind.paper, wind.count > FEW);
    if (!this.#warm) {
      this.#warm = true;
      // The first fade would wait for it.
      renderer.compile(new Mesh(undefined, this.#variant(false, true)), new Camera());
    }
    return material;
  }

  #variant(paper: boolean, many: boolean): RawShaderMaterial {
    const index = (paper ? 2 : 0) + (many ? 1 : 0);
    let material = this.#variants[index];
    if (!material) {
      const { waves, phases } = this.wind;
      material = texelMaterial(
        treeShader(stepFragment),
        { ...this.uniforms, windWaves: { value: waves }, windPhases: { value: phases } },
        { WIND_WAVES: many ? 2 * FEW : FEW, ...(paper ? { WIND_PAPER: 1 } : {}) },
      );
      material.name = `wind step, ${paper ? 'paper' : 'plain'} ${many ? 'many' : 'few'}`;
      this.#variants[index] = material;
    }
    return material;
  }
}

const known = new WeakMap<WebGLRenderer, StepMaterials>();

/** The step's shaders of a renderer. */
export function stepMaterialsOf(renderer: WebGLRenderer): StepMaterials {
  let materials = known.get(renderer);
  if (!materials) {
    materials = new StepMaterials();
    known.set(renderer, materials);
  }
  return materials;
}
