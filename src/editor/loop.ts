/** What the loop needs of the clock. */
export interface Ticking {
  readonly playing: boolean;
  readonly time: number;
  /** Takes the time of the frame in milliseconds; steps as often as the rate asks. */
  tick(now: number): void;
}

/**
 * Draws when there is something to draw: while time runs, while the picture moves by itself, or after `invalidate`.
 *
 * A hidden page gets no animation frames; the clock must not jump over the time that it was hidden.
 */
export class Loop {
  private scheduled = 0;
  private last = 0;
  private interval = 0;
  private readonly listeners = new Set<(time: number) => void>();

  private readonly clock: Ticking;
  private readonly draw: (time: number) => void;
  private readonly moving: () => boolean;
  private readonly covered: () => boolean;

  /** `covered`: nothing of the picture can be seen, so time stands and nothing is drawn until the next `invalidate` after it. */
  constructor(
    clock: Ticking,
    draw: (time: number) => void,
    moving: () => boolean,
    covered: () => boolean = () => false,
  ) {
    this.clock = clock;
    this.draw = draw;
    this.moving = moving;
    this.covered = covered;
  }

  /** Milliseconds from frame to frame while playing, smoothed; 0 where time stands. */
  get frameInterval(): number {
    return this.interval;
  }

  /** Nothing is left to draw. */
  get idle(): boolean {
    return this.scheduled === 0;
  }

  /** Something changed: one more frame. */
  readonly invalidate = (): void => {
    this.scheduled ||= requestAnimationFrame(this.frame);
  };

  /** Calls back with the time in seconds after each frame; returns how to stop. */
  readonly onFrame = (listener: (time: number) => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  private readonly frame = (now: number): void => {
    this.scheduled = 0;
    if (this.covered()) return;
    const { clock } = this;
    const passed = now - this.last;
    this.last = now;
    // Pauses and hidden pages are no frames.
    if (!clock.playing) this.interval = 0;
    else if (passed < 2000) this.interval = this.interval ? this.interval + (passed - this.interval) * 0.1 : passed;
    clock.tick(now);
    this.draw(clock.time);
    if (clock.playing || this.moving()) this.invalidate();
    for (const listener of this.listeners) listener(clock.time);
  };
}
