import { SWAY_LAYERS } from '../pack/layout.ts';
import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';
import { createWindState, type WindState, windStateAt } from './fade.ts';
import { type LoopGap, loopWind } from './loop.ts';
import { poseTree } from './pose-tree.ts';
import { type FillWind, SpringRun } from './spring-run.ts';
import { swayTexels } from './sway.ts';
import type { Wind } from './wind.ts';

/** What of a tree is posed. */
export type TreeToLoop = Pick<PackedTree, 'pieceCount' | 'pieces' | 'restPose' | 'mechanics'>;

/** Longest time in seconds that springs get to forget how they began. */
const LONGEST_RUN_IN = 300;

/** Parts of a second of the sway's own clock. */
const PARTS = 4096;

/**
 * The poses of a tree in a wind that was made to come around: the same at any time and `seconds` later.
 *
 * The wind is that of [start, start + seconds) with its speeds nudged (`loopWind`), again and again for ever, so that the springs have felt
 * it for so long that they come around too. The swings of the model `sway` are nudged to whole numbers of them in the loop. Always posed
 * `exact`.
 */
export class LoopedPoses {
  readonly seconds: number;
  /** Largest relative change of a speed; what of the wind does not come around. */
  readonly change: number;
  readonly open: readonly LoopGap[];
  /** Seconds that the springs ran before the loop, 0 for the other models. */
  readonly runIn: number;
  /** How far a bend is off where the loop closes. */
  readonly seam: number;
  readonly #tree: TreeToLoop;
  readonly #wind: Wind;
  readonly #start: number;
  readonly #state = createWindState();
  readonly #springs: SpringRun | null;
  readonly #sway: TexelArray | null;
  /** Seconds of the sway's clock that the loop is long. */
  readonly #swaySeconds: number;

  /** `seam`: how far off, in bend, the springs may be where the loop closes. */
  constructor(tree: TreeToLoop, wind: Wind, start: number, seconds: number, seam = 1e-4) {
    const looped = loopWind(wind, seconds, start);
    this.#tree = tree;
    this.#wind = looped.wind;
    this.#start = start;
    this.seconds = seconds;
    this.change = looped.change;
    this.#swaySeconds = 2 ** Math.round(Math.log2(seconds));
    this.#sway = wind.model === 'sway' ? wholeSwings(tree, this.#wind, seconds, this.#swaySeconds) : null;
    this.open = looped.open.filter((gap) => gap !== 'sway');
    this.#springs = wind.model === 'spring' ? new SpringRun(tree, this.fill) : null;
    [this.runIn, this.seam] = this.#settle(seam);
  }

  /** The wind at `time` seconds after the start of the loop. */
  readonly fill: FillWind = (time: number, out: WindState): void => {
    const within = time - this.seconds * Math.floor(time / this.seconds);
    windStateAt(this.#wind, this.#start + within, undefined, out);
    if (this.#sway) out.time = (within / this.seconds) * this.#swaySeconds;
  };

  /** The pose at `time` seconds of the loop, 0..seconds, laid out as the rest pose; `out` is overwritten. */
  at(time: number, out?: Float32Array): Float32Array {
    const bends = {
      ...(this.#springs ? this.#springs.bendsAt(this.runIn + time) : {}),
      ...(this.#sway ? { sway: this.#sway } : {}),
    };
    this.fill(time, this.#state);
    return poseTree(this.#tree, this.#state, 'exact', undefined, out, bends);
  }

  /** Runs the springs through the loop until it closes. */
  #settle(seam: number): [runIn: number, off: number] {
    const springs = this.#springs;
    if (!springs) return [0, 0];
    let before = springs.at(0).slice();
    let off = Number.POSITIVE_INFINITY;
    let turns = 0;
    while (off > seam && (turns + 1) * this.seconds <= Math.max(LONGEST_RUN_IN, 2 * this.seconds)) {
      turns++;
      const now = springs.at(turns * this.seconds);
      off = 0;
      // The bends are the first two numbers of the first target.
      for (let i = 0; i < this.#tree.pieceCount; i++) {
        for (let k = 0; k < 2; k++) off = Math.max(off, Math.abs(now[4 * i + k]! - before[4 * i + k]!));
      }
      before = now.slice();
    }
    // The loop that was found to close is the one from here on: the state here is that of one loop before.
    return [turns * this.seconds, off];
  }
}

/** The swings of a tree, each making a whole number of turns in `seconds`, which the clock of the sway takes for `clock` seconds. */
function wholeSwings(tree: TreeToLoop, wind: Wind, seconds: number, clock: number): TexelArray {
  const texels = swayTexels(tree, wind.sway);
  const gain = layerStart(texels, SWAY_LAYERS.GAIN);
  const one = PARTS / clock;
  for (let i = 0; i < tree.pieceCount; i++) {
    for (const k of [2, 3]) {
      const at = gain + 4 * i + k;
      texels.data[at] = one * Math.max(1, Math.round((texels.data[at]! * seconds) / PARTS));
    }
  }
  return texels;
}
