/** What a mouse points at. */
export interface HoverOptions {
  readonly canvas: HTMLElement;
  /** The stem at a point of the window. */
  pick(x: number, y: number): number | null;
  /** Nothing is pointed at now: the camera turns, a handle is held, or a click means something else. */
  blocked(): boolean;
  tell(stem: number | null): void;
}

/** Finds the stem that the mouse points at, once a frame at most; fingers point at nothing. */
export class Hover {
  readonly #of: HoverOptions;
  #at: { readonly x: number; readonly y: number } | null = null;
  #told: number | null = null;
  #asked = 0;

  constructor(of: HoverOptions) {
    this.#of = of;
    const { canvas } = of;
    canvas.addEventListener('pointermove', (event) => {
      if (event.pointerType !== 'mouse') return;
      this.#at = event.buttons === 0 ? { x: event.clientX, y: event.clientY } : null;
      this.#ask();
    });
    canvas.addEventListener('pointerleave', () => {
      this.#at = null;
      this.#ask();
    });
  }

  /** Another tree: what was pointed at is gone. */
  forget(): void {
    this.#told = null;
  }

  #ask(): void {
    this.#asked ||= requestAnimationFrame(() => {
      this.#asked = 0;
      const stem = this.#at && !this.#of.blocked() ? this.#of.pick(this.#at.x, this.#at.y) : null;
      if (stem === this.#told) return;
      this.#told = stem;
      this.#of.tell(stem);
    });
  }
}
