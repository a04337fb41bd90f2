import type { Texture, WebGLRenderer, WebGLRenderTarget } from 'three';
import { STATE_TARGETS } from '../core/pack/layout.ts';
import type { BendTextures } from './bend-textures.ts';
import { floatTarget } from './float-target.ts';
import type { StateBackend } from './state-run.ts';
import { STEP } from './step.ts';
import type { StepMaterials } from './step-materials.ts';
import type { ProgramOf } from './step-variants.ts';
import type { TexelDraw } from './texel-draw.ts';
import type { WindSource } from './wind-source.ts';

/** The targets of a set: the state, and after it the lean, which the pose reads (shaders/wind/spring.frag). */
const NAMES = [...Object.keys(STATE_TARGETS), 'lean'];
export const LEAN = NAMES.length - 1;

/** What a call of the backend draws with; the same for all steps of an update. */
export interface SpringContext {
  readonly renderer: WebGLRenderer;
  readonly materials: StepMaterials;
  readonly source: WindSource;
}

/**
 * The springs of a tree on the GPU: their state in two sets of four RGBA32F targets, one draw over all pieces a step, and copies of
 * it as checkpoints. `StateRun` says which steps; the caller holds the renderer's settings (`PassState`).
 */
export class SpringPass implements StateBackend {
  readonly #bend: BendTextures;
  readonly #draw: TexelDraw;
  readonly #range: number;
  readonly #size: readonly [width: number, height: number];
  readonly #sets: readonly [WebGLRenderTarget, WebGLRenderTarget];
  readonly #kept: WebGLRenderTarget[] = [];
  #latest = 0;
  #context: SpringContext | null = null;

  /** `range` of `draw` is that of all pieces; `width`, `height` of the textures in texels. */
  constructor(bend: BendTextures, draw: TexelDraw, range: number, width: number, height: number) {
    this.#bend = bend;
    this.#draw = draw;
    this.#range = range;
    this.#size = [width, height];
    this.#sets = [this.#target('state even'), this.#target('state odd')];
  }

  /** The set that holds the latest state, and the one that holds the state before. */
  get latest(): WebGLRenderTarget {
    return this.#sets[this.#latest];
  }

  get previous(): WebGLRenderTarget {
    return this.#sets[1 - this.#latest];
  }

  /** On the GPU: sets and checkpoints. */
  get bytes(): number {
    return (2 + this.#kept.length) * bytesOfState(...this.#size);
  }

  /** What the next calls draw with; `pieces` and `log2Width` of the materials are set. */
  use(context: SpringContext): void {
    this.#context = context;
  }

  begin(step: number): void {
    this.#fill(step * STEP);
    this.#compute('spring seed', this.latest, null);
  }

  advance(step: number): void {
    // The force of the step's middle stands for all of it.
    this.#fill((step - 0.5) * STEP);
    const from = this.latest.textures;
    this.#latest = 1 - this.#latest;
    this.#compute('spring', this.latest, from);
  }

  back(): void {
    this.#latest = 1 - this.#latest;
  }

  save(slot: number): void {
    this.#kept[slot] ??= this.#target(`state kept ${slot}`);
    this.#copy(this.latest, this.#kept[slot]);
  }

  restore(slot: number): void {
    this.#copy(this.#kept[slot], this.latest);
  }

  dispose(): void {
    for (const target of [...this.#sets, ...this.#kept]) target.dispose();
    this.#kept.length = 0;
    this.#context = null;
  }

  #target(name: string): WebGLRenderTarget {
    return floatTarget(
      ...this.#size,
      NAMES.map((part) => `${name} ${part}`),
    );
  }

  #fill(time: number): void {
    const { materials, source } = this.#given();
    source.fill(time, materials.wind);
    materials.take();
    materials.uniforms.springs.value = this.#bend.springs(materials.wind);
  }

  #compute(program: ProgramOf, into: WebGLRenderTarget, from: Texture[] | null): void {
    const { renderer, materials } = this.#given();
    materials.uniforms.springFirst.value = from;
    this.#draw.draw(renderer, into, materials.material(renderer, program), this.#range);
  }

  #copy(from: WebGLRenderTarget, to: WebGLRenderTarget): void {
    const { renderer, materials } = this.#given();
    materials.uniforms.springFirst.value = from.textures;
    this.#draw.draw(renderer, to, materials.keep, this.#range);
  }

  #given(): SpringContext {
    if (!this.#context) throw new Error('SpringPass is used before it was told what to draw with.');
    return this.#context;
  }
}

/** Bytes of one state of a tree whose textures are of this size. */
export const bytesOfState = (width: number, height: number): number => width * height * 16 * NAMES.length;
