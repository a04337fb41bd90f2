import { PIECE_LAYERS, POSE_TARGETS } from '../pack/layout.ts';
import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';
import { createWindState, type WindState } from './fade.ts';
import { windForce } from './force.ts';
import { poseTree } from './pose-tree.ts';
import { chainOf } from './probe-chain.ts';
import { PROBE_RATE, type ProbeReading } from './probe-history.ts';
import { type Bends, uses } from './push.ts';
import { SpringRun } from './spring-run.ts';
import { springOmega } from './spring-texels.ts';
import { swayTexels } from './sway.ts';
import type { Wind } from './wind.ts';

/** The wind that a probe feels. */
export interface ProbeWind {
  /** Overwrites `out` with the wind at a time in seconds, and returns it. */
  at(time: number, out: WindState): WindState;
  /** The document that blows, or fades in. */
  readonly wind: Wind;
}

/** Steps of the springs at a time, between two looks at whether there is time for more. */
const SLICE = 64;

/** Steps before the first reading from which the springs run, at most: ten minutes, in which every branch forgets how it began. */
const LONGEST_RUN = 600 * PROBE_RATE;

/**
 * What one piece of a tree feels and does, computed on the CPU by the same functions as the whole tree, for the piece and its
 * ancestors alone: microseconds a step. The same tree, wind and step give the same numbers, whatever was asked before.
 */
export class Probe {
  readonly piece: number;
  /** The piece with its ancestors as a tree of its own; the piece is the last. */
  readonly chain: PackedTree;
  readonly #felt: ProbeWind;
  readonly #state = createWindState();
  #pose: Float32Array;
  #before: Float32Array;
  /** Step that the pose is of; NaN before the first. */
  #step = Number.NaN;
  #springs: SpringRun | null = null;
  /** Step of the clock at which the springs' own step 0 is. */
  #begin = 0;
  #sway: { texels: TexelArray; reading: string; rate: number } | null = null;

  /** Throws RangeError where the tree has no such piece. */
  constructor(tree: PackedTree, piece: number, wind: ProbeWind) {
    this.piece = piece;
    this.chain = chainOf(tree, piece);
    this.#felt = wind;
    this.#pose = this.chain.restPose.data.slice();
    this.#before = this.#pose.slice();
  }

  /** Natural frequency in hertz of the probed branch in the wind that blows. */
  get natural(): number {
    const { spring, stiffness } = this.#felt.wind;
    return springOmega(this.chain, this.chain.pieceCount - 1, spring, stiffness) / (2 * Math.PI);
  }

  /** Forgets where it stands: the past has changed. */
  restart(): void {
    this.#step = Number.NaN;
    this.#springs = null;
  }

  /** Makes ready to read `step`, for as long as `more` says so; false: call it again. Only springs have a past to run through. */
  prepare(step: number, more: () => boolean): boolean {
    if (!uses(this.#felt.at(step / PROBE_RATE, this.#state), 'spring')) {
      this.#springs = null;
      return true;
    }
    if (this.#springs === null || step < this.#begin) this.#startSprings(step);
    const run = this.#springs as SpringRun;
    const own = step - this.#begin;
    while (run.step < own - SLICE) {
      run.stepTo(Math.max(0, run.step) + SLICE);
      if (run.step < own - SLICE && !more()) return false;
    }
    return true;
  }

  /** What it feels and does at `step` (times 1/60 s); quick where that is the step after the last. */
  read(step: number, out: ProbeReading): ProbeReading {
    this.#goTo(step);
    const { chain } = this;
    const last = chain.pieceCount - 1;
    const state = this.#felt.at(step / PROBE_RATE, this.#state);
    const tip = layerStart(chain.pieces, PIECE_LAYERS.TIP) + 4 * last;
    const { data } = chain.pieces;
    const [fx, fy] = windForce(state, data[tip], data[tip + 1], data[tip + 2]);
    const end = layerStart(chain.restPose, POSE_TARGETS.P3) + 4 * last;
    const rest = chain.restPose.data;
    out.fx = fx;
    out.fy = fy;
    out.x = this.#pose[end] - rest[end];
    out.y = this.#pose[end + 1] - rest[end + 1];
    out.z = this.#pose[end + 2] - rest[end + 2];
    return out;
  }

  /**
   * Where the piece's end is at a time in seconds, between steps too; tree space, metres. null while the springs are elsewhere in time,
   * and for `lagged` poses, which depend on when a frame was drawn.
   */
  endAt(time: number): [number, number, number] | null {
    if (this.#felt.wind.pose === 'lagged') return null;
    const { chain } = this;
    const state = this.#felt.at(time, this.#state);
    const run = this.#springs;
    const own = time - this.#begin / PROBE_RATE;
    if (uses(state, 'spring') && (!run || own < 0 || Math.abs(own * PROBE_RATE - run.step) > SLICE)) return null;
    const pose = poseTree(chain, state, 'exact', undefined, undefined, this.#bends(state, own));
    const end = layerStart(chain.restPose, POSE_TARGETS.P3) + 4 * (chain.pieceCount - 1);
    return [pose[end], pose[end + 1], pose[end + 2]];
  }

  #goTo(step: number): void {
    if (step === this.#step) return;
    const { chain } = this;
    this.prepare(step, () => true);
    if (this.#felt.wind.pose === 'lagged' && step !== this.#step + 1) {
      // Each piece hears of its parent one step late: after as many steps as there are pieces all is as if it had always run.
      this.#pose.set(chain.restPose.data);
      for (let k = Math.max(0, step - chain.pieceCount); k < step; k++) this.#poseAt(k);
    }
    this.#poseAt(step);
    this.#step = step;
  }

  #poseAt(step: number): void {
    [this.#pose, this.#before] = [this.#before, this.#pose];
    const time = step / PROBE_RATE;
    const state = this.#felt.at(time, this.#state);
    const bends = this.#bends(state, (step - this.#begin) / PROBE_RATE);
    poseTree(this.chain, state, this.#felt.wind.pose, this.#before, this.#pose, bends);
  }

  /** What the models besides `direct` need; `own`: seconds since the springs' step 0. */
  #bends(state: WindState, own: number): Bends {
    return {
      ...(uses(state, 'sway') ? { sway: this.#swayTexels(state) } : {}),
      ...(uses(state, 'spring') && this.#springs ? this.#springs.bendsAt(own) : {}),
    };
  }

  #swayTexels({ sway }: WindState): TexelArray {
    const { reading, rate } = sway;
    if (this.#sway?.reading !== reading || this.#sway.rate !== rate) {
      this.#sway = { texels: swayTexels(this.chain, sway), reading, rate };
    }
    return this.#sway.texels;
  }

  #startSprings(step: number): void {
    this.#begin = Math.max(0, step - LONGEST_RUN);
    const begin = this.#begin / PROBE_RATE;
    this.#springs = new SpringRun(this.chain, (time, out) => void this.#felt.at(time + begin, out), {
      checkpoints: 96,
    });
  }
}
