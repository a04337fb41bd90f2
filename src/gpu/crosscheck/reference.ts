import type { PackedTree } from '../../core/pack/packed.ts';
import { createWindState } from '../../core/wind/fade.ts';
import { poseTreePlainly } from '../../core/wind/pose-plainly.ts';
import { type Bends, uses } from '../../core/wind/push.ts';
import { SpringRun } from '../../core/wind/spring-run.ts';
import { swayTexels } from '../../core/wind/sway.ts';
import { STEP } from '../step.ts';
import type { WindSource } from '../wind-source.ts';

/** What the pass must compute, by TypeScript: the poses of a tree in a wind at ever later times. */
export class Reference {
  readonly #tree: PackedTree;
  readonly #source: WindSource;
  readonly #state = createWindState();
  readonly #springs: SpringRun;

  constructor(tree: PackedTree, source: WindSource) {
    this.#tree = tree;
    this.#source = source;
    this.#springs = new SpringRun(tree, (time, out) => source.fill(time, out));
  }

  /** The pose at a time in seconds; the lagged one by as many steps as the tree is deep, which is all it depends on. */
  pose(time: number): Float32Array {
    const tree = this.#tree;
    if (this.#source.pose === 'exact') {
      return poseTreePlainly(tree, this.#at(time), 'exact', undefined, undefined, this.#bends(time));
    }
    const step = Math.round(time / STEP);
    let pose = tree.restPose.data;
    for (let n = step - tree.depthStart.length + 2; n <= step; n++) {
      pose = poseTreePlainly(tree, this.#at(n * STEP), 'lagged', pose, undefined, this.#bends(n * STEP));
    }
    return pose;
  }

  /** The springs' state at a time, laid out as STATE_TARGETS. */
  springs(time: number): Float32Array {
    return this.#springs.at(time);
  }

  #at(time: number) {
    this.#source.fill(time, this.#state);
    return this.#state;
  }

  #bends(time: number): Bends {
    const wind = this.#at(time);
    const sway = uses(wind, 'sway') ? swayTexels(this.#tree, wind.sway) : undefined;
    return {
      ...(uses(wind, 'spring') ? this.#springs.bendsAt(time) : {}),
      ...(sway ? { sway } : {}),
    };
  }
}
