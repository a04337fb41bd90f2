import { type Checkpoint, Checkpoints } from './checkpoints.ts';
import type { WindSource } from './wind-source.ts';

/** What keeps a state and the one before it, and computes the next; on the GPU or on the CPU. */
export interface StateBackend {
  /** Makes the state of `step` the latest: at rest in the wind of its time, as if that had always blown. There is none before it. */
  begin(step: number): void;
  /** Computes the state of `step` from the latest, that of the step before, which stays readable. */
  advance(step: number): void;
  /** Makes the state before the latest the latest. */
  back(): void;
  /** Copies the latest state into a place, or makes a copy the latest. */
  save(slot: number): void;
  restore(slot: number): void;
}

/** Whether a first state may begin where it is asked for; `always`: every state may, whenever the last is far. */
export type Near = boolean | 'always';

/** What a run asks a wind source: whether the wind that its states come from is still the wind. */
export type Past = Pick<WindSource, 'epoch' | 'past' | 'revision'>;

/** Steps that a state may be behind after an edit and still be led on instead of run again from the start: half a second. */
const FOLLOWS = 30;

/** Beyond these steps, six hours, a run does not start at time 0 but at a whole minute, one or two minutes before what is asked for. */
const FARTHEST = 6 * 3600 * 60;
const MINUTE = 3600;

/** Where the run to a step starts: the same for a minute of steps, so that a look at a step and one at the next are of one run. */
const startOf = (step: number): number => (step > FARTHEST ? (Math.floor(step / MINUTE) - 1) * MINUTE : 0);

/**
 * Decides which steps a stateful model runs, and from which checkpoint, so that a state is a function of its step alone: seeking
 * gives what playing gives, bit for bit.
 *
 * The exception is an edit while playing: the state goes on from what it is, since nothing may jump, and no checkpoint is kept
 * of it. Seeking, or a new epoch of the wind, runs from time 0 again. Long ways are run in slices, a few steps a call.
 */
export class StateRun {
  readonly #backend: StateBackend;
  readonly #checkpoints: Checkpoints;
  readonly #slice: number;
  /** Step of the latest state; NaN where there is none. */
  #latest = Number.NaN;
  /** Is the state before the latest there? */
  #pair = false;
  #pure = true;
  #epoch = Number.NaN;
  #past = Number.NaN;
  #revision = Number.NaN;
  /** The first state may begin where it is asked for; and one has begun so. */
  #near: Near;
  #nearby = false;
  /** The first step that was asked for last: what is on screen. */
  #shown = 0;
  /** From where to where a run in slices goes; NaN where none is under way. */
  #from = Number.NaN;
  #to = Number.NaN;

  /**
   * `capacity`: checkpoints at most; `slice`: steps a call at most, beyond the few that a draw needs; `near`: the first state begins
   * where it is asked for, as after an edit while playing, until `settle`; `always`: so does every other, nothing of the past counts and
   * nothing of it is kept.
   */
  constructor(backend: StateBackend, capacity: number, slice: number, near: Near = false) {
    this.#near = near;
    this.#backend = backend;
    this.#checkpoints = new Checkpoints(capacity);
    this.#slice = slice;
  }

  /** How much of a long way has been run, 0..1; null where the state is there. */
  get catchingUp(): number | null {
    if (Number.isNaN(this.#from)) return null;
    return Math.min(1, Math.max(0, (this.#latest - this.#from) / (this.#to - this.#from)));
  }

  /** Step of the latest state; NaN before the first. */
  get latest(): number {
    return this.#latest;
  }

  /** Does the state follow from the wind alone, from time 0 on? */
  get pure(): boolean {
    return this.#pure;
  }

  /** Can the state of `step` be read: is it the latest, or the one before? */
  has(step: number): boolean {
    return step === this.#latest || (this.#pair && step === this.#latest - 1);
  }

  /** Everything is gone, as after a lost context: the next call runs from the start. */
  forget(): void {
    this.#checkpoints.clear();
    this.#latest = Number.NaN;
    this.#pair = false;
    this.#epoch = Number.NaN;
    this.#from = Number.NaN;
  }

  /** What began near is run again from the start, by the next call. */
  settle(): void {
    if (this.#near === 'always') return;
    this.#near = false;
    if (this.#nearby) this.forget();
  }

  /** The model is not in use: when it is again, by an edit while playing, it starts at rest in the wind of the moment. */
  rest(): void {
    this.#latest = Number.NaN;
    this.#pair = false;
    this.#from = Number.NaN;
  }

  /**
   * Makes the states of the steps `first` to `last` (whole, >= 0; at most one more) readable, or with `visit` calls it while each of
   * them is the latest, in order. False where the way is long and goes on with the next call; nothing was visited then.
   */
  reach(first: number, last: number, source: Past, visit?: (step: number) => void): boolean {
    this.#heed(first, source);
    this.#shown = visit ? last : first;
    const there = visit ? this.#latest === first : this.has(first) && this.has(last);
    if (!there) this.#start(first, source, visit !== undefined);
    let left = this.#slice;
    while (this.#latest < first) {
      if (left-- === 0) {
        this.#underWay(first);
        return false;
      }
      this.#advance();
    }
    this.#from = Number.NaN;
    // Only after an edit can the latest be beyond the first: it stands in for those that are gone.
    visit?.(first);
    for (let step = first + 1; step <= last; step++) {
      if (this.#latest < step) this.#advance();
      visit?.(step);
    }
    return true;
  }

  /** What has become of the wind since the last call. */
  #heed(first: number, source: Past): void {
    const { epoch, revision } = source;
    const past = source.past ?? revision;
    const goesOn = this.#near === 'always' && !Number.isNaN(this.#latest);
    if (epoch !== this.#epoch && !goesOn) {
      this.forget();
      this.#pure = true;
    } else if (past !== this.#past) {
      this.#checkpoints.clear();
      this.#from = Number.NaN;
      this.#pure = false;
      if (Number.isNaN(this.#latest)) this.#begin(first);
    } else if (revision !== this.#revision && !Number.isNaN(this.#latest)) {
      // The wind is another from now on: what was computed beyond now goes.
      this.#checkpoints.dropAfter(this.#shown);
      if (this.#latest > this.#shown) {
        if (this.#pair) this.#stepBack();
        else this.#latest = Number.NaN;
      }
    }
    this.#note(source);
  }

  #note(source: Past): void {
    this.#epoch = source.epoch;
    this.#past = source.past ?? source.revision;
    this.#revision = source.revision;
  }

  /** Makes a state at or before `first` the latest; after an edit, one near it will do. */
  #start(first: number, source: Past, visits: boolean): void {
    if (visits && this.#pair && this.#latest === first + 1) {
      this.#stepBack();
      return;
    }
    const ahead = first - this.#latest; // NaN without a state
    if (this.#pure) {
      const checkpoint = this.#checkpoints.before(first);
      if (ahead >= 0 && !(checkpoint && checkpoint.step > this.#latest)) return;
      this.#from = Number.NaN;
      if (checkpoint) {
        this.#restore(checkpoint);
        return;
      }
    } else if (ahead >= (visits ? -FOLLOWS : -1) && ahead <= FOLLOWS) return;
    this.#from = Number.NaN;
    this.#nearby = this.#near !== false;
    this.#pure = !this.#near;
    this.#begin(this.#near ? first : startOf(first));
    if (this.#near !== 'always') this.#near = false;
    // The wind at the start may have ended a fade, which is an epoch of its own and no reason to start again.
    this.#note(source);
  }

  #restore({ step, slot }: Checkpoint): void {
    this.#backend.restore(slot);
    this.#latest = step;
    this.#pair = false;
  }

  #begin(step: number): void {
    this.#backend.begin(step);
    this.#latest = step;
    this.#pair = false;
  }

  #stepBack(): void {
    this.#backend.back();
    this.#latest--;
    this.#pair = false;
  }

  #advance(): void {
    this.#backend.advance(++this.#latest);
    this.#pair = true;
    if (!this.#pure) return;
    const slot = this.#checkpoints.keep(this.#latest, this.#shown);
    if (slot !== null) this.#backend.save(slot);
  }

  #underWay(to: number): void {
    if (Number.isNaN(this.#from)) this.#from = this.#latest - this.#slice;
    this.#to = to;
  }
}
