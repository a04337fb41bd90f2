import { DEFAULT_CLEARINGS, DEFAULT_FOREST, DEFAULT_HILLS } from '../core/forest/default-forest.ts';
import type { ForestDocument } from '../core/forest/forest.ts';
import type { GreyMap } from '../core/forest/grey-map.ts';
import { roundForest } from '../core/forest/parse-forest.ts';

/** A message to the reader. */
export interface Notice {
  readonly kind: 'error' | 'note';
  readonly title: string;
  readonly lines: readonly string[];
}

/** What the page shows: the forest, the pictures put in, and whether time runs. */
export interface ForestState {
  readonly document: ForestDocument;
  readonly heightMap: GreyMap | null;
  readonly densityMap: GreyMap | null;
  readonly playing: boolean;
  readonly open: boolean;
  readonly notice: Notice | null;
  /** Files are held over the page. */
  readonly dragging: boolean;
}

/** Holds the state and tells who listens of each change. */
export class Store {
  #state: ForestState;
  readonly #listeners: ((state: ForestState, before: ForestState) => void)[] = [];

  constructor(start: Partial<ForestState>) {
    this.#state = {
      document: DEFAULT_FOREST,
      heightMap: null,
      densityMap: null,
      playing: true,
      open: true,
      notice: null,
      dragging: false,
      ...start,
    };
  }

  get state(): ForestState {
    return this.#state;
  }

  listen(listener: (state: ForestState, before: ForestState) => void): void {
    this.#listeners.push(listener);
  }

  set(change: Partial<ForestState>): void {
    const before = this.#state;
    this.#state = { ...before, ...change };
    for (const listener of this.#listeners) listener(this.#state, before);
  }

  /** Changes the document; its numbers are those that a link keeps. */
  edit(change: Partial<ForestDocument>): void {
    this.set({ document: roundForest({ ...this.#state.document, ...change }) });
  }

  /** Takes a picture of heights, or puts hills back in its stead. */
  setHeightMap(map: GreyMap | null, name: string): void {
    const { terrain } = this.#state.document;
    const heights = terrain.kind === 'map' ? terrain : { black: 0, white: 80 };
    this.set({ heightMap: map, notice: null });
    this.edit({
      terrain: map ? { kind: 'map', name, black: heights.black, white: heights.white } : DEFAULT_HILLS,
    });
  }

  /** Takes a picture of densities, or puts clearings back in its stead. */
  setDensityMap(map: GreyMap | null, name: string): void {
    this.set({ densityMap: map, notice: null });
    this.edit({ density: map ? { kind: 'map', name } : DEFAULT_CLEARINGS });
  }
}
