/** Steps from checkpoint to checkpoint near the time that is shown. */
export const SPACING = 16;

/** A kept step and the place that holds its state. */
export interface Checkpoint {
  readonly step: number;
  readonly slot: number;
}

/**
 * Which steps of a run are kept, in which of `capacity` places: dense about the step that is shown and ever sparser away from it,
 * so that a short way back is a short way to run and an hour still fits. Bookkeeping alone: the caller copies states.
 */
export class Checkpoints {
  /** By step, ascending. */
  readonly #kept: Checkpoint[] = [];
  readonly #capacity: number;

  constructor(capacity: number) {
    this.#capacity = capacity;
  }

  get steps(): number[] {
    return this.#kept.map(({ step }) => step);
  }

  /** The place for a copy of `step`, or null: there is one, or it would be thinned out before `shown`, the step on its way to the screen. */
  keep(step: number, shown: number): number | null {
    if (step % spacing(Math.abs(shown - step)) !== 0) return null;
    const after = this.#kept.findIndex((each) => each.step >= step);
    if (after >= 0 && this.#kept[after].step === step) return null;
    const slot = this.#kept.length < this.#capacity ? this.#free() : this.#thin(shown);
    const place = this.#kept.findIndex((each) => each.step > step);
    this.#kept.splice(place < 0 ? this.#kept.length : place, 0, { step, slot });
    return slot;
  }

  /** The last checkpoint at or before `step`. */
  before(step: number): Checkpoint | null {
    let found: Checkpoint | null = null;
    for (const each of this.#kept) if (each.step <= step) found = each;
    return found;
  }

  /** Forgets what is later than `step`. */
  dropAfter(step: number): void {
    const first = this.#kept.findIndex((each) => each.step > step);
    if (first >= 0) this.#kept.length = first;
  }

  clear(): void {
    this.#kept.length = 0;
  }

  #free(): number {
    let slot = 0;
    while (this.#kept.some((each) => each.slot === slot)) slot++;
    return slot;
  }

  /** Drops the checkpoint whose going leaves the smallest gap for how far it is from `shown`. */
  #thin(shown: number): number {
    let best = 0;
    let least = Number.POSITIVE_INFINITY;
    for (let i = 0; i < this.#kept.length; i++) {
      const { step } = this.#kept[i];
      const before = i > 0 ? this.#kept[i - 1].step : 0;
      const after = i + 1 < this.#kept.length ? this.#kept[i + 1].step : Math.max(shown, step) + SPACING;
      const loss = (after - before) / (Math.abs(shown - step) + SPACING);
      if (loss < least) {
        least = loss;
        best = i;
      }
    }
    return this.#kept.splice(best, 1)[0].slot;
  }
}

/** How far apart checkpoints are worth keeping at a distance from what is shown: about an eighth of it. */
function spacing(distance: number): number {
  let apart = SPACING;
  while (apart * 16 <= distance) apart *= 2;
  return apart;
}
