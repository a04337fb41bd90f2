/** Pixels that a tip may move between two poses of it. */
const PIXELS = 0.5;
/** Frames between two poses at most. */
const MOST = 8;
/** Seconds between two poses at most: springs that are led on by more than half a second begin anew (`StateRun`). */
const SECONDS = 0.45;
/** Longest step of the clock that is taken for a frame. */
const FRAME = 0.25;

/**
 * In which frames a grove is posed: the less its tips move on screen, the fewer. All of its pieces, whenever it is: were deep levels left
 * out they would hang in the air where their branches were.
 */
export class GrovePace {
  readonly #own: number;
  /** Factor on the pixels that tips may move. */
  slack = 1;
  #step = 1 / 60;
  #time = Number.NaN;
  #period = 1;
  #posed = Number.NEGATIVE_INFINITY;
  #wind = Number.NaN;

  /** `own`: a number of the grove's, so that not all are posed in the same frame. */
  constructor(own: number) {
    this.#own = own;
  }

  /** Every how many frames it is posed. */
  get period(): number {
    return this.#period;
  }

  /** Is it to be posed in frame number `frame`, at `time` seconds? `speed`: pixels a second of its fastest tips; `wind`: another number where another wind blows. */
  due(frame: number, time: number, speed: number, seen: boolean, wind: number): boolean {
    const step = time - this.#time;
    this.#time = time;
    if (step > 0 && step < FRAME) this.#step += 0.1 * (step - this.#step);
    const most = Math.max(1, Math.min(MOST, Math.floor(SECONDS / this.#step)));
    const wanted = seen ? Math.floor((PIXELS * this.slack) / Math.max(speed * this.#step, 1e-9)) : most;
    this.#period = Math.max(1, Math.min(most, wanted));
    const first = !Number.isFinite(this.#posed);
    // Where time jumped, or stood still, the next frame shows it as of then.
    const jumped = step < 0 || step >= FRAME || (step === 0 && (time !== this.#posed || wind !== this.#wind));
    if (!first && !jumped && (frame + this.#own) % this.#period !== 0) return false;
    this.#posed = time;
    this.#wind = wind;
    return true;
  }

  /** It has never been posed: another one stands in its place. */
  reset(): void {
    this.#posed = Number.NEGATIVE_INFINITY;
  }
}
