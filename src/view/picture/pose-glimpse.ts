/** Seconds of the clock that a pose is good for to pick from while time runs. */
const FRESH = 0.4;

/**
 * The pose of a moment ago, for picking: it is read back without holding up a frame, and only while somebody picks.
 *
 * The first pick asks for it, and what follows has it.
 */
export class PoseGlimpse {
  private readonly read: () => Promise<Float32Array | null>;
  private pose: Float32Array | null = null;
  /** Of the pose; NaN where there is none. */
  private time = Number.NaN;
  /** Counts trees and edits: what was asked for before one is not used. */
  private round = 0;
  private asked = false;

  constructor(read: () => Promise<Float32Array | null>) {
    this.read = read;
  }

  /** The pose as drawn at about `time` seconds, or null. */
  at(time: number): Float32Array | null {
    if (time !== this.time) this.ask(time);
    return Math.abs(time - this.time) <= FRESH ? this.pose : null;
  }

  /** What was read is of the past: another tree, or another wind. */
  forget(): void {
    this.round++;
    this.pose = null;
    this.time = Number.NaN;
  }

  /** Reads anew, for picks to come. */
  ask(time: number): void {
    if (this.asked) return;
    this.asked = true;
    const { round } = this;
    const done = (pose: Float32Array | null): void => {
      this.asked = false;
      if (round !== this.round || !pose) return;
      this.pose = pose;
      this.time = time;
    };
    this.read().then(done, () => done(null));
  }
}
