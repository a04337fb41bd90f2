import { seedOf } from '../../core/file/shipped-index.ts';
import type { Season } from '../../core/species/season.ts';
import { STILL } from '../../core/wind/wind.ts';
import type { Glimpse } from '../../view/picture/glimpse.ts';
import type { Editor } from '../editor.ts';
import type { SpeciesEntry } from '../session.ts';
import { loadSpecies } from '../species-source.ts';
import { firstWind } from '../winds-source.ts';

/** The one portrait that moves: what is pointed at, on the canvas that the page then has for it. */
export class Live {
  readonly #editor: Editor;
  readonly #changed: () => void;
  #glimpse: Glimpse | null = null;
  #wish: { readonly entry: SpeciesEntry; readonly season: Season } | null = null;
  /** The canvas that is drawn on. */
  #canvas: HTMLCanvasElement | null = null;
  /** The browser draws no second picture. */
  #failed = false;

  constructor(editor: Editor, changed: () => void) {
    this.#editor = editor;
    this.#changed = changed;
  }

  /** Whether pictures may move: not where the reader's system asks for less motion. */
  static wanted(): boolean {
    return !matchMedia('(prefers-reduced-motion: reduce)').matches;
  }

  /** Whether a species should have a canvas over its portrait. */
  shows(id: string): boolean {
    return this.#wish?.entry.id === id;
  }

  /** This species is to move, as it looks in a season. */
  wish(entry: SpeciesEntry, season: Season): void {
    if (this.#failed || !Live.wanted()) return;
    if (this.#wish?.entry === entry && this.#wish.season === season) return;
    this.#canvas = null;
    this.#wish = { entry, season };
    this.#changed();
  }

  /** Nothing moves. */
  stop(): void {
    if (!this.#wish) return;
    this.#wish = null;
    this.#canvas = null;
    this.#glimpse?.stop();
    this.#changed();
  }

  /** Draws on the canvas that `place` has for the wish, once it is there and the first tree of the page has been drawn, panels and all. */
  follow(place: Element): void {
    const wish = this.#wish;
    const canvas = place.querySelector<HTMLCanvasElement>('canvas.glimpse');
    if (!wish || !canvas || canvas === this.#canvas || !this.#editor.session.getState().panels) return;
    this.#canvas = canvas;
    void this.#show(canvas, wish.entry, wish.season);
  }

  dispose(): void {
    this.#wish = null;
    this.#canvas = null;
    this.#glimpse?.dispose();
    this.#glimpse = null;
  }

  async #show(canvas: HTMLCanvasElement, entry: SpeciesEntry, season: Season): Promise<void> {
    try {
      const species = await loadSpecies(entry);
      if (canvas !== this.#canvas) return;
      const wind = firstWind(this.#editor.session.getState().winds) ?? STILL;
      const { Glimpse } = await import('../../view/picture/glimpse.ts');
      if (canvas !== this.#canvas) return;
      this.#glimpse ??= new Glimpse();
      await this.#glimpse.show(canvas, { species, seed: seedOf(entry), season, wind }, () => {
        canvas.dataset.live = '';
      });
    } catch {
      // A still portrait is the picture of a browser that draws no other; the page of the species says what is wrong with its file.
      this.#failed = true;
      this.stop();
    }
  }
}
