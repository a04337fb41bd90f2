import { Camera, type IUniform, Mesh, type RawShaderMaterial, type WebGLRenderer } from 'three';
import keepFragment from '../../shaders/wind/keep.frag';
import seedFragment from '../../shaders/wind/seed.frag';
import springFragment from '../../shaders/wind/spring.frag';
import stepFragment from '../../shaders/wind/step.frag';
import { createWindState, type WindState } from '../core/wind/fade.ts';
import { forceUniforms } from '../core/wind/force-variant.ts';
import { swayClock, swayUniform } from '../core/wind/sway.ts';
import { RecordTextures } from './record-texture.ts';
import { definesOf, type ProgramOf, variantOf, variantsToWarm } from './step-variants.ts';
import { texelMaterial } from './texel-draw.ts';
import { treeShader } from './tree-shader.ts';

/** What passes set before a draw; the rest follows from the wind. */
type Given =
  | 'pieces'
  | 'log2Width'
  | 'parentPose'
  | 'springs'
  | 'sways'
  | 'springFirst'
  | 'springQ'
  | 'springLean'
  | 'springFraction';

/**
 * The variants of the wind's shaders for one renderer, shared by all trees: another tree must not compile them again.
 *
 * A pass fills `wind`, calls `take`, and sets the values of the uniforms before each draw; three sends them with every draw into
 * another target.
 */
export class StepMaterials {
  readonly wind: WindState = createWindState();
  readonly uniforms: Record<Given, IUniform> = {
    pieces: { value: null },
    log2Width: { value: 0 },
    parentPose: { value: null },
    springs: { value: null },
    sways: { value: null },
    springFirst: { value: null },
    springQ: { value: [] },
    springLean: { value: [] },
    springFraction: { value: 0 },
  };
  /** Writes the rest pose; set `uniforms.restPose.value` first. */
  readonly seed = texelMaterial(seedFragment, { restPose: { value: null } });
  /** Copies the springs' state in `springFirst`. */
  readonly keep = texelMaterial(keepFragment, { springFirst: this.uniforms.springFirst });
  readonly #taken = {
    windExponents: { value: new Float32Array(2) },
    windSoftness: { value: 1 },
    windModelFade: { value: 1 },
    windSway: { value: new Float32Array(4) },
    windClock: { value: new Float32Array(2) },
    windRecord: { value: null } as IUniform,
    springInertia: { value: 0 },
  };
  readonly #force: Record<string, IUniform>;
  readonly #records = new RecordTextures();
  /** By number: no name is put together at every draw. */
  readonly #variants = new Map<number, RawShaderMaterial>();
  readonly #cold: number[] = [];

  constructor() {
    const values = Object.entries(forceUniforms(this.wind));
    this.#force = Object.fromEntries(values.map(([name, value]) => [name, { value }]));
  }

  /** Sets the uniforms that follow from `wind`, which was just filled. */
  take(): void {
    const { wind } = this;
    const taken = this.#taken;
    taken.windExponents.value[0] = wind.forceExponent;
    taken.windExponents.value[1] = wind.lengthExponent;
    taken.windSoftness.value = wind.softness;
    taken.windModelFade.value = wind.modelFade;
    taken.windRecord.value = this.#records.of(wind.record);
    taken.springInertia.value = wind.spring.inertia;
    swayUniform(wind.sway, wind.loudness, taken.windSway.value);
    swayClock(wind.time, taken.windClock.value);
  }

  /** The shader of a program for `wind`. A later call compiles, one at a time, what a fade or a gust would else have to wait for. */
  material(renderer: WebGLRenderer, program: ProgramOf): RawShaderMaterial {
    const variant = variantOf(program, this.wind, this.uniforms.springFraction.value === 0);
    let material = this.#variants.get(variant);
    if (!material) {
      material = this.#make(variant);
      this.#cold.push(...variantsToWarm(variant));
    } else if (this.#cold.length > 0) {
      const next = this.#cold.shift() as number;
      if (!this.#variants.has(next)) renderer.compile(new Mesh(undefined, this.#make(next)), new Camera());
    }
    return material;
  }

  #make(variant: number): RawShaderMaterial {
    const { program, defines } = definesOf(variant);
    const fragment = treeShader(program === 'pose' ? stepFragment : springFragment);
    const material = texelMaterial(fragment, { ...this.uniforms, ...this.#taken, ...this.#force }, defines);
    material.name = `wind ${program}, ${Object.entries(defines).flat().join(' ')}`;
    this.#variants.set(variant, material);
    return material;
  }
}

const known = new WeakMap<WebGLRenderer, StepMaterials>();

/** The wind's shaders of a renderer. */
export function stepMaterialsOf(renderer: WebGLRenderer): StepMaterials {
  let materials = known.get(renderer);
  if (!materials) {
    materials = new StepMaterials();
    known.set(renderer, materials);
  }
  return materials;
}
