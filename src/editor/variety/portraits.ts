import type { Species } from '../../core/species/species.ts';
import type { GrownTree } from '../../view/picture/grow-tree.ts';
import type { PortraitOptions } from '../../view/picture/picture.ts';
import { isAborted, PreviewGrower } from '../../view/picture/preview-grower.ts';
import { type Frame, frameOf, type Sketch, sketchOf } from './sketch.ts';

/** A tree that is to be shown. */
export interface Wish {
  readonly species: Species;
  readonly seed: number;
}

/** What there is of it so far. */
export interface Portrait extends Wish {
  readonly sketch: Sketch | null;
  /** Address of the picture. */
  readonly url: string | null;
  /** Metres; null until it is grown. */
  readonly height: number | null;
  /** Why there is none: growing failed. */
  readonly failed: string | null;
}

/** Pixels of the pictures. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** How a grown tree becomes a picture. */
export type Draw = (options: PortraitOptions, grown: GrownTree, species: Species) => Promise<Blob>;

/** Milliseconds after which a slider that is not moved rests: then portraits are worth while. */
export const RESTS = 250;

/** Trunk and main branches: the bearing of a tree, grown in a blink. */
const BEARING = { levels: 2, leaves: false } as const;

const nextFrame = (): Promise<void> => new Promise((done) => requestAnimationFrame(() => done()));

/**
 * Makes pictures of trees that are not the one on the screen: first the bearing of all of them as sketches, then one portrait after another, all
 * at the same scale. Between two of them the page draws a frame. The newest `show` wins.
 */
export class Portraits {
  list: readonly Portrait[] = [];
  frame: Frame | null = null;
  private readonly grower = new PreviewGrower();
  private readonly portrait: Draw;
  private readonly changed: () => void;
  private round: AbortController | null = null;

  constructor(portrait: Draw, changed: () => void) {
    this.portrait = portrait;
    this.changed = changed;
  }

  /** Nothing is left to make. */
  get idle(): boolean {
    return this.round === null;
  }

  /** Shows these trees in place of those before; `draft`: as sketches alone. */
  show(wishes: readonly Wish[], size: Size, draft = false): void {
    this.stop();
    const before = this.list;
    // A single picture that follows a slider stays until the next one is there.
    const kept = wishes.length === 1 && before.length === 1 ? before[0]! : null;
    if (!kept) for (const { url } of before) if (url) URL.revokeObjectURL(url);
    this.list = wishes.map((wish) => ({ sketch: null, height: null, failed: null, url: null, ...kept, ...wish }));
    const round = new AbortController();
    this.round = round;
    void this.make(round.signal, size, draft).finally(() => {
      if (this.round === round) this.round = null;
      this.changed();
    });
    this.changed();
  }

  /** Drops what is not made yet. */
  stop(): void {
    this.round?.abort();
    this.round = null;
    this.grower.clear();
  }

  /** Drops all, the pictures too, and ends the worker. */
  dispose(): void {
    this.stop();
    for (const { url } of this.list) if (url) URL.revokeObjectURL(url);
    this.list = [];
    this.frame = null;
    this.grower.dispose();
  }

  private put(index: number, change: Partial<Portrait>, signal: AbortSignal): void {
    if (signal.aborted) return;
    this.list = this.list.map((p, i) => (i === index ? { ...p, ...change } : p));
    this.changed();
  }

  private async make(signal: AbortSignal, size: Size, draft: boolean): Promise<void> {
    const wishes = this.list;
    const sketches = await Promise.all(
      wishes.map(async ({ species, seed }, i) => {
        try {
          const sketch = sketchOf(await this.grower.grow(species, seed, BEARING, signal));
          this.put(i, { sketch, failed: null }, signal);
          return sketch;
        } catch (error) {
          this.fail(i, error, signal);
          return null;
        }
      }),
    );
    const grown = sketches.filter((s) => s !== null);
    if (signal.aborted || grown.length === 0) return;
    this.frame = frameOf(grown);
    this.changed();
    for (let i = 0; i < wishes.length && !draft && !signal.aborted; i++) {
      if (sketches[i]) await this.draw(i, wishes[i]!, size, this.frame, signal);
    }
  }

  private async draw(i: number, { species, seed }: Wish, size: Size, frame: Frame, signal: AbortSignal): Promise<void> {
    try {
      const grown = await this.grower.grow(species, seed, {}, signal);
      await nextFrame();
      if (signal.aborted) return;
      const blob = await this.portrait({ ...size, frame }, grown, species);
      if (signal.aborted) return;
      const last = this.list[i]!.url;
      if (last) URL.revokeObjectURL(last);
      this.put(i, { url: URL.createObjectURL(blob), height: grown.stats.height }, signal);
    } catch (error) {
      // A browser that draws no portraits shows the sketch; a tree that does not grow says why.
      if (error instanceof Error && /^Growth|NothingGrown/.test(error.name)) this.fail(i, error, signal);
    }
  }

  private fail(i: number, error: unknown, signal: AbortSignal): void {
    if (isAborted(error)) return;
    this.put(i, { failed: error instanceof Error ? error.message : String(error) }, signal);
  }
}
