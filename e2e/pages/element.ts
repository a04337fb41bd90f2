import '../../src/element/define.ts';
import type { Species } from '../../src/core/species/species.ts';
import { fetchedFrom } from '../../src/element/shipped-source.ts';
import { WindTreeElement } from '../../src/element/wind-tree-element.ts';
import { small } from './grown.ts';

// The element by itself, for e2e/element.spec.ts: species that ship, with few branches and leaves.
const files = fetchedFrom('/');
const kept = new Map<string, Species>();
WindTreeElement.shipped = {
  species: [],
  winds: [],
  async speciesOf(id, signal) {
    const species = kept.get(id) ?? small(await files.speciesOf(id, signal));
    kept.set(id, species);
    return species;
  },
  windOf: (id, signal) => files.windOf(id, signal),
};

const place = document.querySelector('#place') as HTMLElement;

const canvasOf = (element: Element): HTMLCanvasElement =>
  element.shadowRoot!.querySelector('canvas') as HTMLCanvasElement;

const elements = {
  place,

  /** Puts an element on the page. */
  add(attributes: Record<string, string>, inside = ''): WindTreeElement {
    const element = document.createElement('wind-tree');
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    if (inside) {
      const child = document.createElement('p');
      child.slot = inside;
      child.textContent = `In the slot ${inside}`;
      element.append(child);
    }
    place.append(element);
    return element;
  },

  /** What the next event of a name says. */
  next: (element: Element, name: string): Promise<unknown> =>
    new Promise((done) =>
      element.addEventListener(name, (event) => done((event as CustomEvent).detail), { once: true }),
    ),

  /** Colours of the picture: a flat one has few. */
  colours(element: Element): number {
    const canvas = canvasOf(element);
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  },

  /** The picture as text, to be compared. */
  picture: (element: Element): string => canvasOf(element).toDataURL(),

  renderer: async () => (await import('../../src/element/shared-renderer.ts')).sharedRenderer,
};

Object.assign(window, { elements });
declare global {
  interface Window {
    elements: typeof elements;
    /** Counted by the test before anything runs: contexts and workers that were made, and workers that live. */
    made: { contexts: number; workers: number; living: number };
  }
}
document.documentElement.dataset.ready = 'true';
