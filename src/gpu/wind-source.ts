import { WindFader, type WindState } from '../core/wind/fade.ts';
import type { Placement } from '../core/wind/force.ts';
import type { Wind } from '../core/wind/wind.ts';

/** The wind as a pass takes it: a function of time. */
export interface WindSource {
  readonly pose: Wind['pose'];
  /** Another number whenever `fill` would give another wind for the same time: a pass skips a frame that it has posed already. */
  readonly revision: number;
  /**
   * Another number whenever the wind of the past is another and the model's state is to be what that makes of it, as when a fade is
   * settled or the clock is paused: a stateful model runs again from time 0.
   */
  readonly epoch: number;
  /**
   * Another number whenever the wind of the past is another at all, by a fade too: a stateful model goes on from its state, but what it
   * kept of the past is void. With a new `revision` alone the wind differs from now on. Left out: every revision is a new past.
   */
  readonly past?: number;
  /** Overwrites `out` with the wind at `time` seconds. */
  fill(time: number, out: WindState): void;
}

let revisions = 0;

/** A wind document, without a fade, as felt by a tree at `place`. */
export function windSource(wind: Wind, place?: Placement): WindSource {
  const fader = new WindFader(wind);
  const revision = --revisions; // below zero: never that of a source that counts its edits up
  return {
    pose: wind.pose,
    revision,
    epoch: revision,
    past: revision,
    fill: (time, out) => {
      fader.at(time, place, out);
    },
  };
}
