import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { createWindState, type WindState } from './fade.ts';
import { SPRING_RATE } from './spring.ts';
import { type SpringTree, springTexels } from './spring-texels.ts';
import { mixSprings, startSprings, stateLength, stepSprings } from './spring-tree.ts';
import type { SpringSettings } from './wind.ts';

/** Overwrites `out` with the wind at `time` seconds: `WindFader.at`, or `windStateAt` of one wind. */
export type FillWind = (time: number, out: WindState) => void;

export interface SpringRunOptions {
  /** Most states that are kept to seek back to, at least 2; each has 12 floats a piece. 24 by default. */
  readonly checkpoints?: number;
}

/** Part of a step that makes no difference: a time that was made of whole steps is one of them again. */
const WHOLE = 1e-4;

/**
 * The springs of a whole tree through time, on the CPU: state n is a function of the wind and n alone, so that seeking gives what
 * playing gives, bit for bit.
 *
 * The exception is `edit`: the state goes on from what it is, as a tree would; seeking back, or `restart`, makes the past that of
 * the new wind. Checkpoints are thinned so that memory stays bounded however long it runs.
 */
export class SpringRun {
  readonly #tree: SpringTree & Pick<PackedTree, 'pieces'>;
  readonly #wind = createWindState();
  readonly #most: number;
  #fill: FillWind;
  #texels: TexelArray;
  #settings: SpringSettings | null = null;
  #softness = Number.NaN;
  #latest: Float32Array;
  #before: Float32Array;
  #mixed: Float32Array;
  #step = -1;
  /** Is the state before the latest in `#before`? */
  #pair = false;
  #pure = true;
  #kept: { step: number; state: Float32Array }[] = [];
  #spacing = 16;

  constructor(tree: SpringTree & Pick<PackedTree, 'pieces'>, fill: FillWind, options: SpringRunOptions = {}) {
    this.#tree = tree;
    this.#fill = fill;
    this.#most = Math.max(2, options.checkpoints ?? 24);
    fill(0, this.#wind);
    this.#texels = this.#springs();
    this.#latest = new Float32Array(stateLength(this.#texels));
    this.#before = this.#latest.slice();
    this.#mixed = this.#latest.slice();
  }

  /** Step of the latest state, -1 before the first. */
  get step(): number {
    return this.#step;
  }

  /** Does the state follow from the wind alone, from time 0 on? */
  get pure(): boolean {
    return this.#pure;
  }

  /** Layers of SPRING_LAYERS for the wind of the latest step. */
  get texels(): TexelArray {
    return this.#texels;
  }

  /** Steps whose states are kept. */
  get kept(): readonly number[] {
    return this.#kept.map(({ step }) => step);
  }

  /** The state of step n (whole, >= 0), laid out as STATE_TARGETS; valid until the next call. */
  stepTo(n: number): Float32Array {
    if (this.#pair && n === this.#step - 1) return this.#before;
    if (n < this.#step || this.#step < 0) this.#seek(n);
    while (this.#step < n) this.#advance();
    return this.#latest;
  }

  /** The state at a time in seconds (before 0: at 0): that of a step, or between two; valid until the next call. */
  at(time: number): Float32Array {
    const x = Math.max(0, time * SPRING_RATE);
    const nearest = Math.round(x);
    if (Math.abs(x - nearest) < WHOLE) return this.stepTo(nearest);
    const first = Math.floor(x);
    // The later of the two last: both are then at hand.
    if (!(this.#pair && this.#step === first + 1)) {
      this.stepTo(first);
      this.stepTo(first + 1);
    }
    return mixSprings(this.#before, this.#latest, x - first, this.#mixed);
  }

  /** What `poseTree` takes for the pose at a time. */
  bendsAt(time: number): { springs: { texels: TexelArray; state: Float32Array } } {
    const state = this.at(time);
    return { springs: { texels: this.#texels, state } };
  }

  /** Another wind from now on: the state goes on from what it is. */
  edit(fill: FillWind): void {
    this.#fill = fill;
    this.#kept = [];
    this.#pure = this.#step <= 0;
    // What is between two steps ends in another state than before.
    if (this.#step <= 0) this.#step = -1;
  }

  /** Forgets the past: the next call runs from time 0. */
  restart(fill: FillWind = this.#fill): void {
    this.#fill = fill;
    this.#kept = [];
    this.#step = -1;
    this.#pair = false;
    this.#pure = true;
  }

  #seek(n: number): void {
    this.#pair = false;
    const from = this.#pure ? this.#kept.findLast(({ step }) => step <= n) : undefined;
    if (from) {
      this.#latest.set(from.state);
      this.#step = from.step;
      return;
    }
    this.#kept = [];
    this.#pure = true;
    this.#step = 0;
    this.#fill(0, this.#wind);
    startSprings(this.#tree, this.#springs(), this.#wind, this.#latest);
    this.#keep();
  }

  #advance(): void {
    // The force of the step's middle stands for all of it.
    this.#fill((this.#step + 0.5) / SPRING_RATE, this.#wind);
    stepSprings(this.#tree, this.#springs(), this.#wind, this.#latest, this.#before);
    [this.#latest, this.#before] = [this.#before, this.#latest];
    this.#pair = true;
    this.#step++;
    if (this.#pure && this.#step % this.#spacing === 0) this.#keep();
  }

  /** The springs for the wind as last filled, made anew only where its settings changed. */
  #springs(): TexelArray {
    const { spring, softness } = this.#wind;
    if (spring !== this.#settings || softness !== this.#softness) {
      this.#texels = springTexels(
        this.#tree,
        spring,
        1 / softness,
        1 / SPRING_RATE,
        this.#settings ? this.#texels : undefined,
      );
      this.#settings = spring;
      this.#softness = softness;
    }
    return this.#texels;
  }

  #keep(): void {
    if (this.#kept.some(({ step }) => step === this.#step)) return;
    this.#kept.push({ step: this.#step, state: this.#latest.slice() });
    this.#kept.sort((a, b) => a.step - b.step);
    if (this.#kept.length <= this.#most) return;
    this.#spacing *= 2;
    this.#kept = this.#kept.filter(({ step }) => step % this.#spacing === 0);
  }
}
