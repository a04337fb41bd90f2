import { inSeason, type Season } from '../../core/species/season.ts';
import type { Species } from '../../core/species/species.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { WindTree } from '../wind-tree.ts';
import { CaptureStage } from './capture-stage.ts';
import type { GrownTree } from './grow-tree.ts';
import { PreviewGrower } from './preview-grower.ts';

/** A tree to be seen alive. */
export interface GlimpseOf {
  readonly species: Species;
  readonly seed: number;
  readonly season: Season;
  readonly wind: Wind;
}

/** Trees that were grown lately and are kept: who comes back to one sees it move at once. */
const KEPT = 5;

/** Milliseconds that a frame may take before the picture gets coarser, and how coarse it may get. */
const SLOW = 45;
const COARSEST = 0.5;

/** Milliseconds of a coarse frame at which the tree stands still: moving it would hold up all else on the page. */
const HOPELESS = 800;

/** Seconds that one frame makes up for at most. */
const LONGEST_STEP = 0.1;

/**
 * Shows one tree at a time in the wind, on whatever canvas it is given, framed as portraits are: one renderer, with a context of its own, for
 * as many canvases as a page has. Trees grow in a worker of their own.
 */
export class Glimpse {
  #stage: CaptureStage | null = null;
  readonly #grower = new PreviewGrower();
  readonly #grown = new Map<string, GrownTree>();
  #round: AbortController | null = null;
  #fine = 1;

  /**
   * Shows a tree on `canvas` in place of the last one, until `stop` or the next `show`; `live` is called once its first frame is there.
   * Rejects where it does not grow or the browser cannot draw; never because something else was shown meanwhile.
   */
  async show(canvas: HTMLCanvasElement, of: GlimpseOf, live: () => void): Promise<void> {
    this.stop();
    const round = new AbortController();
    this.#round = round;
    const { signal } = round;
    try {
      const grown = await this.#grow(of, signal);
      if (signal.aborted) return;
      await this.#run(canvas, grown, of, signal, live);
    } catch (error) {
      if (!signal.aborted) throw error;
    }
  }

  /** The tree stands still where it is. */
  stop(): void {
    this.#round?.abort();
    this.#round = null;
    this.#grower.clear();
  }

  /** Frees everything, the context on the GPU too. */
  dispose(): void {
    this.stop();
    this.#grower.dispose();
    this.#grown.clear();
    this.#stage?.dispose();
    this.#stage = null;
  }

  async #grow({ species, seed }: GlimpseOf, signal: AbortSignal): Promise<GrownTree> {
    const key = `${species.name} ${species.latin} ${seed}`;
    const grown = this.#grown.get(key) ?? (await this.#grower.grow(species, seed, {}, signal));
    this.#grown.delete(key);
    this.#grown.set(key, grown);
    const [oldest] = this.#grown.keys();
    if (this.#grown.size > KEPT && oldest !== undefined) this.#grown.delete(oldest);
    return grown;
  }

  async #run(
    canvas: HTMLCanvasElement,
    { packed, stems }: GrownTree,
    { species, season, wind }: GlimpseOf,
    signal: AbortSignal,
    live: () => void,
  ): Promise<void> {
    this.#stage ??= new CaptureStage('stage', new WindTree());
    const stage = this.#stage;
    const show = { levelsShown: Number.POSITIVE_INFINITY, showLeaves: true, view: 'shaded' } as const;
    const dressed = inSeason(species, season);
    stage.take({ packed, stems, species: dressed, wind, show, dark: false, channel: null });
    let [time, last, first] = [0, await nextFrame(), true];
    while (!signal.aborted) {
      const began = performance.now();
      sizeTo(canvas, this.#fine);
      await stage.draw(canvas, time, 'close');
      if (signal.aborted) return;
      await stage.drawn();
      if (signal.aborted) return;
      const took = performance.now() - began;
      if (first) live();
      // The first frame compiles shaders: it says nothing of the next ones.
      else if (took > HOPELESS && this.#fine === COARSEST) return;
      else if (took > SLOW) this.#fine = Math.max(COARSEST, 0.8 * this.#fine);
      first = false;
      const now = await nextFrame();
      time += Math.min(LONGEST_STEP, Math.max(0, (now - last) / 1000));
      last = now;
    }
  }
}

/** As many pixels as the canvas takes on the screen, or part of them. */
function sizeTo(canvas: HTMLCanvasElement, fine: number): void {
  const ratio = Math.min(2, devicePixelRatio) * fine;
  const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
}

const nextFrame = (): Promise<number> => new Promise((done) => requestAnimationFrame(done));
