/** Draws a frame at `now` (milliseconds, as animation frames give it); tells whether another is to follow. */
export type Frame = (now: number) => boolean;

/** Milliseconds of a frame that drawing may take before the rest waits for the next one. */
const BUDGET = 12;

/** One animation frame for everything that draws on the page: many elements take turns, none starves. */
export class FrameLoop {
  /** In the order in which they draw: who has drawn goes to the end. */
  readonly #wanting = new Set<Frame>();
  #asked = 0;
  /** What draws: while it is not through with the last frame there is no next one, or frames would pile up before it. */
  gate: { readonly busy: boolean; mark(): void } | null = null;

  request(frame: Frame): void {
    this.#wanting.add(frame);
    this.#asked ||= requestAnimationFrame((now) => this.#run(now));
  }

  cancel(frame: Frame): void {
    this.#wanting.delete(frame);
  }

  #run(now: number): void {
    this.#asked = 0;
    if (!this.gate?.busy) this.#draw(now);
    if (this.#wanting.size > 0) this.#asked ||= requestAnimationFrame((next) => this.#run(next));
  }

  #draw(now: number): void {
    const began = performance.now();
    for (const frame of [...this.#wanting]) {
      // One that has drawn may have cancelled another.
      if (!this.#wanting.delete(frame)) continue;
      if (frame(now)) this.#wanting.add(frame);
      if (performance.now() - began > BUDGET) break;
    }
    this.gate?.mark();
  }
}

export const frameLoop = new FrameLoop();
