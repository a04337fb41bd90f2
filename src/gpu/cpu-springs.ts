import type { PackedTree, TexelArray } from '../core/pack/packed.ts';
import { createWindState } from '../core/wind/fade.ts';
import { sameValue } from '../core/wind/same-before.ts';
import { springTexels } from '../core/wind/spring-texels.ts';
import { mixSprings, startSprings, stateLength, stepSprings } from '../core/wind/spring-tree.ts';
import type { SpringSettings } from '../core/wind/wind.ts';
import type { StateBackend } from './state-run.ts';
import { STEP } from './step.ts';
import type { WindSource } from './wind-source.ts';

/** The springs of a tree on the CPU, by the reference. `StateRun` says which steps. */
export class CpuSprings implements StateBackend {
  readonly #tree: PackedTree;
  readonly #wind = createWindState();
  #texels: TexelArray | undefined;
  #settings: SpringSettings | null = null;
  #softness = Number.NaN;
  #latest = new Float32Array();
  #previous = new Float32Array();
  #mixed = new Float32Array();
  readonly #kept: Float32Array[] = [];
  #source: WindSource | null = null;

  constructor(tree: PackedTree) {
    this.#tree = tree;
  }

  /** The wind of the next calls. */
  use(source: WindSource): void {
    this.#source = source;
  }

  /** The latest state and the one before, laid out as STATE_TARGETS. */
  get latest(): Float32Array {
    return this.#latest;
  }

  get previous(): Float32Array {
    return this.#previous;
  }

  /** What `poseTree` takes: the springs, `fraction` of the way from one state to another. */
  bends(first: Float32Array, second: Float32Array, fraction: number) {
    const state = fraction === 0 ? first : mixSprings(first, second, fraction, this.#mixed);
    return { springs: { texels: this.#springs(), state } };
  }

  begin(step: number): void {
    this.#fill(step * STEP);
    startSprings(this.#tree, this.#springs(), this.#wind, this.#latest);
  }

  advance(step: number): void {
    // The force of the step's middle stands for all of it.
    this.#fill((step - 0.5) * STEP);
    stepSprings(this.#tree, this.#springs(), this.#wind, this.#latest, this.#previous);
    this.back();
  }

  back(): void {
    [this.#latest, this.#previous] = [this.#previous, this.#latest];
  }

  save(slot: number): void {
    this.#kept[slot] ??= new Float32Array(this.#latest.length);
    this.#kept[slot].set(this.#latest);
  }

  restore(slot: number): void {
    this.#latest.set(this.#kept[slot]);
  }

  #fill(time: number): void {
    this.#source?.fill(time, this.#wind);
  }

  #springs(): TexelArray {
    const { spring, softness } = this.#wind;
    const same = softness === this.#softness && sameValue(spring, this.#settings);
    if (this.#texels && same) return this.#texels;
    this.#settings = structuredClone(spring);
    this.#softness = softness;
    this.#texels = springTexels(this.#tree, spring, 1 / softness, STEP, this.#texels);
    if (this.#latest.length === 0) {
      const floats = stateLength(this.#texels);
      this.#latest = new Float32Array(floats);
      this.#previous = new Float32Array(floats);
      this.#mixed = new Float32Array(floats);
    }
    return this.#texels;
  }
}
