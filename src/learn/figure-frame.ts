import type { Values } from './controls.ts';
import type { FigureSpec } from './figure.ts';
import { words } from './words.ts';

/** What the buttons of a figure do. */
export interface FrameActions {
  play(): void;
  step(): void;
  reset(): void;
  /** The address that shows the figure as it is. */
  link(): string;
}

/** What stands in a `<figure class="live">`: a stage with a canvas, and beside it controls, readouts and buttons. */
export class FigureFrame {
  readonly stage = document.createElement('div');
  readonly canvas = document.createElement('canvas');
  readonly controls = document.createElement('div');
  readonly #title: string;
  readonly #readouts = new Map<string, HTMLElement>();
  readonly #told = document.createElement('p');
  readonly #play: HTMLButtonElement | null = null;
  readonly #still: HTMLImageElement | null;
  readonly #links: { readonly link: HTMLAnchorElement; readonly address: (values: Values) => string }[] = [];

  constructor(figure: HTMLElement, spec: FigureSpec, actions: FrameActions) {
    const { id, title, aspect, narrow, readouts, moves, steps, open, page } = spec;
    this.#title = title;
    figure.id ||= `fig-${id}`;
    figure.setAttribute('aria-label', title);
    this.stage.className = 'stage';
    this.stage.style.setProperty('--aspect', String(aspect));
    this.stage.style.setProperty('--narrow', String(narrow ?? Math.min(aspect, 1.25)));
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', title);
    this.stage.append(this.canvas);
    // The picture that stands there without a script is to be seen until the first drawing.
    this.#still = figure.querySelector<HTMLImageElement>('.still');
    if (this.#still) {
      this.#still.alt = '';
      this.stage.prepend(this.#still);
    }
    const panel = document.createElement('div');
    panel.className = 'panel';
    const heading = document.createElement('p');
    heading.className = 'title';
    heading.textContent = title;
    this.controls.className = 'controls';
    const buttons = document.createElement('div');
    buttons.className = 'buttons';
    const button = (text: string, act: () => void): HTMLButtonElement => {
      const made = document.createElement('button');
      made.type = 'button';
      made.textContent = text;
      made.addEventListener('click', act);
      buttons.append(made);
      return made;
    };
    if (moves) this.#play = button(words.play, () => actions.play());
    if (steps) button(words.step, () => actions.step());
    button(words.reset, () => actions.reset());
    button(words.link, () => void this.#copy(actions.link()));
    const leads = (text: string, address: (values: Values) => string): void => {
      const link = document.createElement('a');
      link.textContent = text;
      buttons.append(link);
      this.#links.push({ link, address });
    };
    if (open) leads(words.open, (values) => `index.html#${open(values)}`);
    if (page) leads(page.name, page.address);
    this.#told.className = 'told';
    this.#told.setAttribute('role', 'status');
    panel.append(heading, this.controls);
    if (readouts.length > 0) panel.append(this.#list(readouts));
    panel.append(buttons, this.#told);
    figure.prepend(this.stage, panel);
    figure.classList.add('mounted');
  }

  /** The canvas has its picture. */
  showDrawn(): void {
    this.#still?.remove();
    this.stage.parentElement?.classList.add('shown');
  }

  showPlaying(playing: boolean): void {
    if (this.#play) this.#play.textContent = playing ? words.pause : words.play;
  }

  showReadouts(readouts: Readonly<Record<string, number | string>>): void {
    for (const [id, element] of this.#readouts) {
      const text = String(readouts[id] ?? '–');
      if (element.textContent !== text) element.textContent = text;
    }
  }

  showLinks(values: Values): void {
    for (const { link, address } of this.#links) link.href = `../${address(values)}`;
  }

  /** Tells screen readers what is to be seen; `aloud`: now, else when they come by. */
  tell(text: string, aloud: boolean): void {
    this.canvas.setAttribute('aria-label', text ? `${this.#title}. ${text}` : this.#title);
    if (aloud) this.#told.textContent = text;
  }

  /** Says why there is no picture. */
  fail(why: string): void {
    const message = document.createElement('p');
    message.className = 'failed';
    message.textContent = why;
    this.stage.replaceChildren(...(this.#still ? [this.#still] : []), message);
  }

  #list(readouts: FigureSpec['readouts']): HTMLElement {
    const list = document.createElement('dl');
    for (const { id, label, unit } of readouts) {
      const row = document.createElement('div');
      const term = document.createElement('dt');
      term.textContent = label;
      const value = document.createElement('dd');
      const number = document.createElement('span');
      number.textContent = '–';
      value.append(number);
      if (unit) {
        const small = document.createElement('small');
        small.textContent = unit === '°' ? unit : `\u2009${unit}`;
        value.append(small);
      }
      row.append(term, value);
      list.append(row);
      this.#readouts.set(id, number);
    }
    return list;
  }

  async #copy(link: string): Promise<void> {
    history.replaceState(null, '', new URL(link).hash);
    // Browsers refuse it without a secure page or the reader's leave: the address bar has it then.
    const copied = await Promise.resolve(navigator.clipboard?.writeText(link))
      .then(() => Boolean(navigator.clipboard))
      .catch(() => false);
    this.#told.textContent = copied ? words.linked : words.unlinked;
    this.#told.classList.add('shown');
  }
}
