/** Milliseconds a frame above which fewer pixels are drawn, and below which more are again. */
const SLOW = 45;
const FAST = 22;
/** Frames that are looked at before anything changes, and how much it changes. */
const LOOK = 6;
const PATIENCE = 90;
const STEP = 0.8;
const LEAST = 0.5;

/** How finely to draw while things move: machines that are too slow for all pixels get fewer, until the picture rests. */
export class Pace {
  private factor = 1;
  private frames = 0;
  private sum = 0;

  /** Factor on the pixels in each direction while things move, LEAST..1. */
  get scale(): number {
    return this.factor;
  }

  /** Takes the milliseconds since the last frame of the same motion; returns whether `scale` has changed. */
  frame(passed: number): boolean {
    this.frames++;
    this.sum += passed;
    const mean = this.sum / this.frames;
    let next = this.factor;
    if (this.frames >= LOOK && mean > SLOW) next = Math.max(LEAST, this.factor * STEP);
    else if (this.frames >= PATIENCE && mean < FAST) next = Math.min(1, this.factor / STEP);
    else if (this.frames < PATIENCE) return false;
    const changed = next !== this.factor;
    this.factor = next;
    this.restart();
    return changed;
  }

  /** Another motion begins: what was measured of the last one is no guide. */
  restart(): void {
    this.frames = 0;
    this.sum = 0;
  }
}
