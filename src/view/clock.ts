/** Steps a second: the grid on which the state of the wind lives, and on which time stands while it rests. */
export const STEPS_PER_SECOND = 60;

/** Seconds that one tick makes up for at most: a page that slept does not leap. */
const LONGEST_TICK = 0.25;

/** 2^48 steps, 149 000 years. */
const LAST = 2 ** 48;

const SLOWEST = 0.1;
const FASTEST = 2;

/** A step that time can stand at: what is no number is 0, and there is an end before numbers have no sixtieths. */
const whole = (n: number): number => Math.min(LAST, Math.max(0, n)) || 0;

/**
 * Time in steps of 1/60 s, and between two of them while it runs, so that slow motion and fast screens do not judder; it rests
 * on whole steps alone. The one thing in a page that is told of the wall clock, through `tick`.
 */
export class Clock {
  #n = 0;
  #rate = 1;
  #playing = false;
  #last = Number.NaN;
  /** Part of the step after `n` that has passed, 0 to below 1; 0 while time rests. */
  #left = 0;

  /** Step that time stands at or has passed last, >= 0. */
  get n(): number {
    return this.#n;
  }

  /** Seconds. */
  get time(): number {
    return (this.#n + this.#left) / STEPS_PER_SECOND;
  }

  get playing(): boolean {
    return this.#playing;
  }

  /** Seconds of the clock a second, 0.1..2; 1 by default. */
  get rate(): number {
    return this.#rate;
  }

  set rate(rate: number) {
    this.#rate = Number.isFinite(rate) ? Math.min(FASTEST, Math.max(SLOWEST, rate)) : 1;
  }

  play(): void {
    this.#playing = true;
    this.#last = Number.NaN;
  }

  /** Rests on the nearest step. */
  pause(): void {
    this.#playing = false;
    this.#n = Math.round(this.#n + this.#left);
    this.#left = 0;
  }

  /** Goes `steps` on, or back where it is below 0; not before 0. */
  step(steps = 1): void {
    this.#n = whole(this.#n + (Math.round(steps) || 0));
  }

  /** Goes to the step nearest to `seconds`. */
  seek(seconds: number): void {
    this.#n = whole(Math.round(seconds * STEPS_PER_SECOND));
    this.#left = 0;
  }

  /** Goes on by what passed since the last tick; `now` in milliseconds, as an animation frame gives it. Returns the steps passed. */
  tick(now: number): number {
    if (!this.#playing) return 0;
    const passed = Number.isNaN(this.#last) ? 0 : Math.min(LONGEST_TICK, Math.max(0, (now - this.#last) / 1000));
    this.#last = now;
    const on = this.#left + passed * this.#rate * STEPS_PER_SECOND;
    // Sixtieths that add up to a step but for rounding are one.
    const steps = Math.floor(on + 1e-6);
    this.#left = Math.max(0, on - steps);
    this.#n += steps;
    return steps;
  }
}
