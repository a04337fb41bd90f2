import { inSeason, type Season } from '../core/species/season.ts';
import type { Species } from '../core/species/species.ts';
import { STILL, type Wind } from '../core/wind/wind.ts';
import type { GrownTree } from '../worker/client.ts';
import type { Drawing } from './drawing.ts';
import { type ErrorType, errorTypeOf, type WindTreeEventDetails } from './element-events.ts';
import { speciesOf, type TreeSource, type WindSourceWish, windOf } from './element-source.ts';
import type { ShippedSource } from './shipped-source.ts';

/** A tree that stands, and what it was grown from. */
export interface Planted {
  readonly grown: GrownTree;
  readonly species: Species;
  readonly seed: number;
}

/** Whose tree it is, and what becomes of it. */
export interface LoaderHost {
  readonly wishes: TreeSource & WindSourceWish & { readonly seed: number; readonly season: Season };
  readonly shipped: ShippedSource;
  /** Loads what draws; null where that cannot be, and has been said. */
  open(signal: AbortSignal): Promise<Drawing | null>;
  /** The lower, the sooner it is grown. */
  priority(): number;
  report(phase: WindTreeEventDetails['progress']['phase'], progress: number): void;
  plant(planted: Planted): void;
  /** The wind has come, or is another; kept when it blows. */
  blow(): Promise<void>;
  /** There is no tree; `windFailed`: the tree stands in still air, or in the wind that it had. */
  failed(type: ErrorType, message: string): void;
  windFailed(type: ErrorType, message: string): void;
}

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Fetches, grows and hands over the tree and the wind of one element; of each the latest wish wins. */
export class TreeLoader {
  readonly #host: LoaderHost;
  #loading: AbortController | null = null;
  #windLoading: AbortController | null = null;
  #windReady: Promise<void> | null = null;
  #planted: Planted | null = null;
  #wind: Wind = STILL;

  constructor(host: LoaderHost) {
    this.#host = host;
  }

  /** The tree that came last, kept when the element is taken out: it need not grow again. */
  get planted(): Planted | null {
    return this.#planted;
  }

  /** The wind as it was loaded. */
  get wind(): Wind {
    return this.#wind;
  }

  /** Forgets the tree that is on its way. */
  cancel(): void {
    this.#loading?.abort();
  }

  /** Forgets all that is on its way. */
  stop(): void {
    this.cancel();
    this.#windLoading?.abort();
    this.#windReady = null;
  }

  async load(): Promise<void> {
    this.#loading?.abort();
    const host = this.#host;
    const loading = new AbortController();
    const { signal } = loading;
    this.#loading = loading;
    host.report('code', 0.02);
    if (!this.#windReady) this.loadWind();
    const { seed } = host.wishes;
    let drawing: Drawing | null = null;
    let grows = false;
    try {
      const [species, opened] = await Promise.all([speciesOf(host.wishes, host.shipped, signal), host.open(signal)]);
      if (signal.aborted || !species || !opened) return;
      drawing = opened;
      grows = true;
      host.report('species', 0.2);
      const [grown] = await Promise.all([
        this.#grow(drawing, species, seed, signal),
        drawing.prepare(inSeason(species, host.wishes.season)),
        this.#windReady,
      ]);
      if (signal.aborted) return;
      this.#planted = { grown, species, seed };
      host.plant(this.#planted);
    } catch (error) {
      if (signal.aborted || drawing?.isAborted(error)) return;
      host.failed(grows ? 'grow' : errorTypeOf(error, 'species'), messageOf(error));
    }
  }

  /** Where a wind was wanted before: another is loaded. */
  reloadWind(): void {
    if (this.#windReady) this.loadWind();
  }

  loadWind(): void {
    this.#windLoading?.abort();
    const host = this.#host;
    const loading = new AbortController();
    this.#windLoading = loading;
    const { signal } = loading;
    this.#windReady = windOf(host.wishes, host.shipped, signal)
      .then((wind) => {
        if (signal.aborted) return;
        this.#wind = wind;
        return host.blow();
      })
      .catch((error: unknown) => {
        if (!signal.aborted) host.windFailed(errorTypeOf(error, 'wind'), messageOf(error));
      });
  }

  #grow(drawing: Drawing, species: Species, seed: number, signal: AbortSignal): Promise<GrownTree> | GrownTree {
    const kept = this.#planted;
    if (kept && kept.species === species && kept.seed === seed) return kept.grown;
    return drawing.grow(this, species, seed, {
      signal,
      priority: () => this.#host.priority(),
      onProgress: ({ stage, done }) => this.#host.report('grow', 0.2 + 0.75 * growing(stage, done)),
    });
  }
}

/** The part of the growing that is done: the stages take about these shares of it. */
function growing(stage: 'grow' | 'fit' | 'pack', done: number): number {
  const [from, share] = ({ grow: [0, 0.6], fit: [0.6, 0.3], pack: [0.9, 0.1] } as const)[stage];
  return from + share * done;
}
