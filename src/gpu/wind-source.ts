import { WindFader, type WindState } from '../core/wind/fade.ts';
import type { Placement } from '../core/wind/force.ts';
import type { Wind } from '../core/wind/wind.ts';

/** The wind as a pass takes it: a function of time. */
export interface WindSource {
  readonly pose: Wind['pose'];
  /** Another number whenever `fill` would give another wind for the same time: a pass skips a frame that it has posed already. */
  readonly revision: number;
  /** Overwrites `out` with the wind at `time` seconds. */
  fill(time: number, out: WindState): void;
}

let revisions = 0;

/** A wind document, without a fade, as felt by a tree at `place`. */
export function windSource(wind: Wind, place?: Placement): WindSource {
  const fader = new WindFader(wind);
  return {
    pose: wind.pose,
    revision: --revisions, // below zero: never that of a source that counts its edits up
    fill: (time, out) => {
      fader.at(time, place, out);
    },
  };
}
