import type { PackedTree } from '../../core/pack/packed.ts';
import { createWindState, windStateAt } from '../../core/wind/fade.ts';
import { poseTree } from '../../core/wind/pose-tree.ts';
import { Probe } from '../../core/wind/probe.ts';
import { SpringRun } from '../../core/wind/spring-run.ts';
import { swayTexels } from '../../core/wind/sway.ts';
import { type BendModelName, DEFAULT_GUST, STILL, type Wind } from '../../core/wind/wind.ts';

/** The three models in the order in which the lesson has them. */
export const MODELS = ['direct', 'spring', 'sway'] as const satisfies readonly BendModelName[];

/** When the gust of this lesson begins, seconds. */
export const GUST_START = 1;

/** One gust along x, and a model that answers it. */
export const gustWind = (model: BendModelName, amplitude: number, rise: number, damping: number): Wind => ({
  ...STILL,
  name: 'One gust',
  model,
  gusts: [{ ...DEFAULT_GUST, start: GUST_START, amplitude, rise, fall: rise, width: 0, speed: 40 }],
  // Half as quick as grown: so small a tree would be too quick to watch.
  spring: { ...STILL.spring, frequency: 0.5, damping },
  // So slight a wind that the limb goes about as far as in the gust.
  sway: { ...STILL.sway, speed: 0.8, gust: 0.4 },
});

/** A wind under which every branch but the trunk is a spring of this frequency and damping ratio. */
export const tunedWind = (name: string, hertz: number, damping: number, wind: Partial<Wind>): Wind => ({
  ...STILL,
  name,
  model: 'spring',
  spring: {
    ...STILL.spring,
    damping: Math.max(0.005, damping),
    levels: [null, hertz, hertz, hertz].map((frequency) => ({ frequency, damping: null })),
  },
  ...wind,
});

/** A whole tree under one wind: its pose at any time. */
export class ModelTree {
  readonly #tree: PackedTree;
  readonly #wind: Wind;
  readonly #run: SpringRun | null;
  readonly #state = createWindState();
  readonly #pose: Float32Array;

  constructor(tree: PackedTree, wind: Wind) {
    this.#tree = tree;
    this.#wind = wind;
    this.#pose = new Float32Array(tree.restPose.data.length);
    this.#run =
      wind.model === 'spring' ? new SpringRun(tree, (time, out) => void windStateAt(wind, time, undefined, out)) : null;
  }

  /** Laid out as `restPose`; overwritten by the next call. */
  at(time: number): Float32Array {
    const bends = {
      ...(this.#run ? this.#run.bendsAt(time) : {}),
      ...(this.#wind.model === 'sway' ? { sway: swayTexels(this.#tree, this.#wind.sway) } : {}),
    };
    const state = windStateAt(this.#wind, time, undefined, this.#state);
    return poseTree(this.#tree, state, 'exact', undefined, this.#pose, bends);
  }
}

/** What one piece feels and does, 60 times a second for some seconds: force and displacement along x, metres. */
export function traceOf(
  tree: PackedTree,
  piece: number,
  wind: Wind,
  seconds: number,
): { force: Float64Array; moved: Float64Array } {
  const probe = new Probe(tree, piece, { wind, at: (time, out) => windStateAt(wind, time, undefined, out) });
  const count = Math.round(60 * seconds);
  const [force, moved] = [new Float64Array(count), new Float64Array(count)];
  const reading = { fx: 0, fy: 0, x: 0, y: 0, z: 0 };
  for (let n = 0; n < count; n++) {
    probe.read(n, reading);
    force[n] = reading.fx;
    moved[n] = reading.x;
  }
  return { force, moved };
}
