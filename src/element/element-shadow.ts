import { elementWords } from './words.ts';

/** What is to be seen of an element at the moment. */
export interface ElementParts {
  /** What the picture shows; empty: it is decoration. */
  readonly label: string;
  /** The camera can be turned. */
  readonly turns: boolean;
  /** Address of the poster's picture, '' for none; null: the poster is gone. */
  readonly poster: string | null;
  /** The poster waits to be pressed. */
  readonly asks: boolean;
  /** 0..1, null: nothing is on its way. */
  readonly progress: number | null;
  /** The browser cannot draw it. */
  readonly unable: boolean;
  readonly message: string;
  readonly status: string;
  readonly controls: boolean;
  readonly paused: boolean;
}

const SVG = 'http://www.w3.org/2000/svg';
const PLAY = 'M4 2.5v11l9.5-5.5z';
const PAUSE = 'M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z';

/** Sets an attribute where it is another, or takes it away: what stays as it was is not told to screen readers again. */
function set(node: Element, name: string, value: string | null): void {
  if (value === null) node.removeAttribute(name);
  else if (node.getAttribute(name) !== value) node.setAttribute(name, value);
}

/** An element with attributes; those of ours that have a part have a class or tag for their looks. */
function made<Made extends Element>(
  node: Made,
  attributes: Readonly<Record<string, string>>,
  ...children: (Node | string)[]
): Made {
  for (const name in attributes) node.setAttribute(name, attributes[name]!);
  node.append(...children);
  return node;
}

const html = <Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Readonly<Record<string, string>> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] => made(document.createElement(tag), attributes, ...children);

const slot = (name: string, ...children: Node[]): HTMLSlotElement => html('slot', { name }, ...children);

/**
 * The shadow tree of one element, made once and set to what is to be seen. It is made of nodes and not of text, so that a page that asks for
 * Trusted Types need allow nothing for it.
 */
export class ElementShadow {
  readonly canvas = html('canvas', { part: 'canvas', width: '1', height: '1' });
  readonly #image = html('img', { alt: '' });
  readonly #show = html(
    'button',
    { part: 'button', class: 'show', type: 'button' },
    icon(PLAY),
    `\u00a0${elementWords.show}`,
  );
  readonly #poster = html('div', { part: 'poster', class: 'poster' }, slot('poster', this.#image), this.#show);
  readonly #fallback = html('div', { class: 'fallback' }, slot('fallback'));
  readonly #bar = html('progress', { part: 'progress', max: '1', 'aria-label': elementWords.progress });
  readonly #progress = slot('progress', this.#bar);
  readonly #message = html('p', { part: 'message', class: 'message' });
  readonly #icon = icon(PAUSE);
  readonly #button = html('button', { part: 'button', type: 'button' }, this.#icon);
  readonly #controls = html('div', { part: 'controls', class: 'controls' }, slot('controls', this.#button));
  readonly #keys = html('p', { id: 'keys', class: 'said' }, elementWords.keys);
  readonly #status = html('p', { part: 'status', class: 'said', role: 'status' });

  /** `onToggle`: the button of the controls was pressed; `onPoster`: the poster. */
  constructor(root: ParentNode, onToggle: () => void, onPoster: () => void) {
    this.#button.onclick = onToggle;
    this.#poster.onclick = onPoster;
    root.append(
      this.canvas,
      html('div', { class: 'ring' }),
      html('slot'),
      this.#poster,
      this.#fallback,
      this.#progress,
      this.#message,
      this.#controls,
      this.#keys,
      this.#status,
    );
  }

  /** Shows what is to be seen. */
  set({ label, turns, poster, asks, progress, unable, message, status, controls, paused }: ElementParts): void {
    const { canvas } = this;
    const decoration = label === '' && !turns;
    canvas.classList.toggle('turns', turns);
    set(canvas, 'role', decoration ? 'presentation' : 'img');
    set(canvas, 'aria-label', decoration ? null : label || elementWords.alt(null, null));
    set(canvas, 'aria-describedby', turns ? 'keys' : null);
    set(canvas, 'tabindex', turns && poster === null ? '0' : null);
    this.#poster.classList.toggle('gone', poster === null);
    // The picture stays while the poster fades.
    if (poster !== null) {
      this.#image.hidden = poster === '';
      set(this.#image, 'src', poster || null);
    }
    this.#show.hidden = !asks;
    this.#fallback.hidden = !unable;
    this.#progress.hidden = progress === null;
    this.#bar.value = progress ?? 0;
    this.#message.hidden = message === '';
    this.#message.textContent = message;
    this.#controls.hidden = !controls;
    set(this.#button, 'aria-label', paused ? elementWords.play : elementWords.pause);
    set(this.#icon.firstElementChild!, 'd', paused ? PLAY : PAUSE);
    this.#keys.hidden = !turns;
    if (this.#status.textContent !== status) this.#status.textContent = status;
  }
}

function icon(path: string): SVGSVGElement {
  const drawn = made(document.createElementNS(SVG, 'path'), { d: path });
  return made(document.createElementNS(SVG, 'svg'), { viewBox: '0 0 16 16', 'aria-hidden': 'true' }, drawn);
}
