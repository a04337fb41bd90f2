/** What a step of the budget means; each keeps what the steps before it gave up. */
export interface ForestStep {
  readonly name: string;
  /** Texels a side of the shadow map, and metres around the viewer that it covers. */
  readonly shadowTexels: number;
  readonly shadowReach: number;
  /** Every how many frames shadows are drawn anew. */
  readonly shadowPeriod: number;
  /** Factors on the pixels from which trees are full, and more than pictures. */
  readonly near: number;
  readonly middle: number;
  /** Frames between two runs of a grove's wind, as a multiple. */
  readonly motion: number;
  /** Pixels of the picture a pixel of the screen, as a part, along a side. */
  readonly resolution: number;
  /** Part of the grass that grows, 0..1. */
  readonly grass: number;
}

const FULL: ForestStep = {
  name: 'full',
  shadowTexels: 2048,
  shadowReach: 90,
  shadowPeriod: 1,
  near: 1,
  middle: 1,
  motion: 1,
  resolution: 1,
  grass: 1,
};

/** Gives up what is missed least first. Each change is shown in the step's name. */
const CHANGES: readonly (Partial<ForestStep> & { name: string })[] = [
  { name: 'fewer shadows', shadowTexels: 1024, shadowReach: 60, shadowPeriod: 2, grass: 0.4 },
  { name: 'nearer cards', near: 1.5 },
  { name: 'nearer impostors', middle: 1.7 },
  { name: 'half the motion', motion: 2 },
  { name: 'lower resolution', resolution: 0.75 },
  { name: 'fewer trees near', near: 2.6, middle: 2.2, grass: 0.1 },
  { name: 'lowest', near: 4, middle: 3.2, motion: 3, resolution: 0.6, shadowPeriod: 4, grass: 0 },
];

/** All steps, the finest first. */
export const FOREST_STEPS: readonly ForestStep[] = [
  FULL,
  ...CHANGES.map((_, i): ForestStep => Object.assign({}, FULL, ...CHANGES.slice(0, i + 1))),
];

/** Frames whose median decides; where they take long, as many as fit into two seconds, but not fewer than the least. */
const LOOK = 30;
const LOOK_TIME = 2000;
const LEAST = 5;
/** A median above this multiple of the budget is too slow, one below that may have more. */
const SLOW = 1.2;
const FAST = 0.8;
/** Looks in a row that must be fast before more is tried, at first; it doubles with every try that was too much. */
const PATIENCE = 4;
/** A time between frames that is no frame: the page slept. Two of them in a row are frames, of a machine that cannot keep up. */
const ASLEEP = 1000;

/** Keeps the frame time by one step at a time: gives way soon, takes back late and ever later. */
export class BudgetMeter {
  #budget: number;
  #step = 0;
  #frames: number[] = [];
  /** Their sum, and whether the last one was so long that the page may have slept. */
  #passed = 0;
  #long = false;
  #fast = 0;
  #patience = PATIENCE;
  #tried = false;
  #median = Number.NaN;
  /** The shortest median so far: what the screen's own rate allows. */
  #shortest = Number.POSITIVE_INFINITY;

  constructor(budget: number) {
    this.#budget = budget;
  }

  /** Milliseconds a frame; another one is tried as if nothing had been too much yet. */
  get budget(): number {
    return this.#budget;
  }

  set budget(milliseconds: number) {
    if (milliseconds === this.#budget) return;
    this.#budget = milliseconds;
    this.#patience = PATIENCE;
    this.#fast = 0;
    this.#tried = false;
    this.restart();
  }

  /** Index in FOREST_STEPS. */
  get step(): number {
    return this.#step;
  }

  /** Milliseconds of the last look; NaN before the first. */
  get median(): number {
    return this.#median;
  }

  /** Takes the milliseconds since the last frame of the same motion. */
  frame(passed: number): void {
    const asleep = passed > ASLEEP && !this.#long;
    this.#long = passed > ASLEEP;
    if (!(passed > 0) || asleep) return;
    this.#frames.push(passed);
    this.#passed += passed;
    const frames = this.#frames.length;
    if (frames < LEAST || (frames < LOOK && this.#passed < LOOK_TIME)) return;
    const median = this.#frames.sort((a, b) => a - b)[frames >> 1] as number;
    this.#median = median;
    this.restart();
    if (median > SLOW * this.#budget) {
      this.#fast = 0;
      if (this.#step >= FOREST_STEPS.length - 1) return;
      this.#step++;
      // What was just taken back was too much: the next try comes later.
      if (this.#tried) this.#patience *= 2;
      this.#tried = false;
      return;
    }
    this.#shortest = Math.min(this.#shortest, median);
    // A screen of 60 Hz never shows less than a budget of 16.7 ms: there, all that it can give counts as fast.
    const capped = median <= 1.02 * this.#budget && median < 1.05 * this.#shortest;
    this.#fast = median < FAST * this.#budget || capped ? this.#fast + 1 : 0;
    if (this.#fast >= this.#patience && this.#step > 0) {
      this.#step--;
      this.#fast = 0;
      this.#tried = true;
    } else if (this.#fast > 0) this.#tried = false;
  }

  /** Another motion begins: what the last one left half measured counts no longer. */
  restart(): void {
    this.#frames = [];
    this.#passed = 0;
  }
}
