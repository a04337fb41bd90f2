import type { Probe } from './probe.ts';
import { ProbeHistory, type ProbeReading } from './probe-history.ts';

/**
 * Keeps the history of a probe up with the clock: a step at a time while it runs; after a jump the past is computed anew, in slices.
 */
export class ProbeRecorder {
  readonly probe: Probe;
  readonly history: ProbeHistory;
  readonly #reading: ProbeReading = { fx: 0, fy: 0, x: 0, y: 0, z: 0 };

  constructor(probe: Probe, history = new ProbeHistory()) {
    this.probe = probe;
    this.history = history;
  }

  /** The past has changed: all of it is computed anew. */
  forget(): void {
    this.history.clear();
    this.probe.restart();
  }

  /**
   * Brings the history to `step` for as long as `more` says so, at least by one step; returns the part that is there, 0..1.
   *
   * Back within the history the newer readings go; on beyond its length the older ones.
   */
  follow(step: number, more: () => boolean = () => true): number {
    const { history, probe } = this;
    const oldest = Math.max(0, step - history.capacity + 1);
    if (history.count > 0 && (step < history.first || history.last < oldest - 1)) history.clear();
    history.cut(step);
    let next = history.count > 0 ? history.last + 1 : oldest;
    if (next <= step && !probe.prepare(next, more)) return 0;
    const begin = next;
    while (next <= step) {
      if (next > begin && !more()) break;
      history.push(next, probe.read(next, this.#reading));
      next++;
    }
    return next > step ? 1 : history.count / (step - oldest + 1);
  }
}
