import { figureNamed } from './permalink.ts';

/** What a page does with a figure. */
export interface Live {
  readonly id: string;
  readonly element: HTMLElement;
  /** It has something new to draw. */
  readonly stale: boolean;
  /** It wants a frame after this one, too. */
  readonly moving: boolean;
  /** It has shown all that it waits for. */
  readonly settled: boolean;
  near: boolean;
  visible: boolean;
  /** Draws, `seconds` after the last time. */
  draw(seconds: number): void;
  /** The theme, the size or the address has changed. */
  changed(): void;
  restore(hash: string): void;
}

/** Longest step of a figure's time, seconds: one that was away goes on where it was. */
const LONGEST = 0.1;

/** The figures of a page: one loop draws those that are near the window and have something new. */
export class LivePage {
  readonly #figures: Live[] = [];
  #waiting = 0;
  #last = 0;
  #seen = false;

  add(figure: Live): void {
    this.#figures.push(figure);
  }

  start(): void {
    const byElement = new Map(this.#figures.map((figure) => [figure.element as Element, figure]));
    const watch = (margin: string, tell: (figure: Live, here: boolean) => void): IntersectionObserver => {
      const observer = new IntersectionObserver(
        (entries) => {
          for (const { target, isIntersecting } of entries) {
            const figure = byElement.get(target);
            if (figure) tell(figure, isIntersecting);
          }
          this.wake();
        },
        { rootMargin: margin },
      );
      for (const { element } of this.#figures) observer.observe(element);
      return observer;
    };
    watch('200px 0px', (figure, here) => {
      figure.near = here;
    });
    watch('0px', (figure, here) => {
      figure.visible = here;
      this.#seen = true;
    });
    const all = (): void => {
      for (const figure of this.#figures) figure.changed();
      this.wake();
    };
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', all);
    document.addEventListener('visibilitychange', () => this.wake());
    this.#print(all);
    const follow = (): void => {
      const named = figureNamed(location.hash);
      const figure = this.#figures.find(({ id }) => id === named);
      if (!figure) return;
      figure.restore(location.hash);
      figure.element.scrollIntoView({ block: 'center' });
    };
    addEventListener('hashchange', follow);
    follow();
    this.wake();
  }

  /** Sees to it that a frame comes. */
  wake(): void {
    if (this.#waiting || document.hidden) return;
    this.#waiting = requestAnimationFrame((now) => {
      this.#waiting = 0;
      const seconds = this.#last > 0 ? Math.min(LONGEST, (now - this.#last) / 1000) : 0;
      const here = this.#figures.filter(({ near }) => near);
      for (const figure of here) if (figure.stale || (figure.moving && figure.visible)) figure.draw(seconds);
      const moving = here.some((figure) => figure.visible && figure.moving);
      this.#last = moving ? now : 0;
      if (this.#seen && this.#figures.every((figure) => !figure.visible || figure.settled)) this.#ready();
      if (moving || here.some(({ stale }) => stale)) this.wake();
    });
  }

  /** All in the window is drawn: now there is time for the stills of scenes, which no print waits for. */
  #ready(): void {
    const { dataset } = document.documentElement;
    if (dataset.ready) return;
    dataset.ready = 'true';
    for (const still of document.querySelectorAll<HTMLImageElement>('.still:not(.drawn)')) still.loading = 'eager';
  }

  /** On paper every figure stands, in the light theme, and every answer is open. */
  #print(redraw: () => void): void {
    const root = document.documentElement;
    let opened: HTMLDetailsElement[] = [];
    addEventListener('beforeprint', () => {
      root.dataset.theme = 'light';
      opened = [...document.querySelectorAll<HTMLDetailsElement>('details:not([open])')];
      for (const details of opened) details.open = true;
      for (const figure of this.#figures) {
        figure.changed();
        figure.draw(0);
      }
    });
    addEventListener('afterprint', () => {
      delete root.dataset.theme;
      for (const details of opened) details.open = false;
      redraw();
    });
  }
}
