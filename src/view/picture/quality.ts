import { type Detail, LEAF_BUDGET } from '../detail.ts';

/** How finely the picture is drawn: as the reader chose, or `auto`, as the machine can. */
export const QUALITIES = ['auto', 'low', 'medium', 'high'] as const;
export type Quality = (typeof QUALITIES)[number];
export type QualityLevel = Exclude<Quality, 'auto'>;

/** What a level means. */
export interface QualitySettings {
  /** Pixels of the screen to each of the page, at most. */
  readonly pixelRatio: number;
  /** Texels a side of the shadow map. */
  readonly shadows: number;
  readonly detail: Detail;
  readonly leafBudget: number;
  /** Part of the grass that grows, 0..1. */
  readonly grass: number;
}

export const QUALITY_SETTINGS: Readonly<Record<QualityLevel, QualitySettings>> = {
  low: { pixelRatio: 1, shadows: 512, detail: 'low', leafBudget: LEAF_BUDGET.low, grass: 0.15 },
  medium: { pixelRatio: 2, shadows: 1024, detail: 'auto', leafBudget: LEAF_BUDGET.auto, grass: 0.36 },
  high: { pixelRatio: 2, shadows: 2048, detail: 'auto', leafBudget: LEAF_BUDGET.high, grass: 1 },
};

/** The level of `auto`, and that of a picture that stands: what a link shows must not depend on what was measured before. */
export const USUAL: QualityLevel = 'medium';

/** Frames whose median decides, and the milliseconds above which it is too slow. */
const LOOK = 60;
const SLOW = 40;
/** Milliseconds below which more may be tried again, and how many looks in a row must say so at first. */
const FAST = 19;
const PATIENCE = 6;

/** Decides by the time between frames what `auto` draws while time runs: it gives way soon, and takes back late and ever later. */
export class QualityMeter {
  #level: QualityLevel = USUAL;
  #frames: number[] = [];
  #fast = 0;
  #patience = PATIENCE;

  get level(): QualityLevel {
    return this.#level;
  }

  /** Takes the milliseconds since the last frame of the same motion. */
  frame(passed: number): void {
    this.#frames.push(passed);
    if (this.#frames.length < LOOK) return;
    const median = this.#frames.sort((a, b) => a - b)[LOOK / 2]!;
    this.#frames = [];
    this.#fast = median < FAST ? this.#fast + 1 : 0;
    if (median > SLOW && this.#level !== 'low') {
      this.#level = 'low';
    } else if (this.#fast >= this.#patience && this.#level === 'low') {
      this.#level = USUAL;
      this.#fast = 0;
      // Should that be too much again, the next try comes later.
      this.#patience *= 2;
    }
  }

  /** Another motion begins: what the last one left half measured counts no longer. */
  restart(): void {
    this.#frames = [];
  }
}
