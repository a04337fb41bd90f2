/** Steps a second: the grid on which time stands, so that the same time always gives the same frame. */
export const STEPS_PER_SECOND = 60;

/** Seconds that one tick makes up for at most: a page that slept does not leap. */
const LONGEST_TICK = 0.25;

/** Time as a whole number of steps of 1/60 s. The one thing in a page that is told of the wall clock, through `tick`. */
export class Clock {
  #n = 0;
  #rate = 1;
  #playing = false;
  #last = Number.NaN;
  #left = 0;

  /** Step that time stands at, >= 0. */
  get n(): number {
    return this.#n;
  }

  /** Seconds. */
  get time(): number {
    return this.#n / STEPS_PER_SECOND;
  }

  get playing(): boolean {
    return this.#playing;
  }

  /** Seconds of the clock a second, 0..16; 1 by default. */
  get rate(): number {
    return this.#rate;
  }

  set rate(rate: number) {
    this.#rate = Number.isFinite(rate) ? Math.min(16, Math.max(0, rate)) : 1;
  }

  play(): void {
    this.#playing = true;
    this.#last = Number.NaN;
    this.#left = 0;
  }

  pause(): void {
    this.#playing = false;
  }

  /** Goes `steps` on, or back where it is below 0; not before 0. */
  step(steps = 1): void {
    this.#n = Math.max(0, this.#n + Math.round(steps));
  }

  /** Goes to the step nearest to `seconds`. */
  seek(seconds: number): void {
    this.#n = Math.max(0, Math.round(seconds * STEPS_PER_SECOND)) || 0;
    this.#left = 0;
  }

  /** Goes on by what passed since the last tick; `now` in milliseconds, as an animation frame gives it. Returns the steps made. */
  tick(now: number): number {
    if (!this.#playing) return 0;
    const passed = Number.isNaN(this.#last) ? 0 : Math.min(LONGEST_TICK, Math.max(0, (now - this.#last) / 1000));
    this.#last = now;
    this.#left += passed * this.#rate * STEPS_PER_SECOND;
    const steps = Math.floor(this.#left + 1e-6);
    this.#left = Math.max(0, this.#left - steps);
    this.#n += steps;
    return steps;
  }
}
