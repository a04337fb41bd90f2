import type { Species } from '../../core/species/species.ts';
import { STILL } from '../../core/wind/wind.ts';
import { WindTree } from '../wind-tree.ts';
import { CaptureStage, type Setting, type Sitter } from './capture-stage.ts';
import { frameView } from './frame-view.ts';
import type { GrownTree } from './grow-tree.ts';
import type { PortraitOptions } from './picture.ts';

/** Milliseconds after which the stage of the portraits is given back: a grid of seeds asks for many in a row. */
const IDLE = 8000;

const QUALITY = 0.9;

/** Takes small pictures of trees at rest, one after the other, on a stage that they share: with its ground, or where there is a frame alone. */
export class Portraits {
  #stage: CaptureStage | null = null;
  #around: Setting | null = null;
  #queue: Promise<unknown> = Promise.resolve();
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** The whole tree at rest, as WebP or, where the browser writes none, PNG. */
  take(
    grown: GrownTree,
    species: Species,
    dark: boolean,
    options: PortraitOptions,
    scene: Sitter['scene'],
  ): Promise<Blob> {
    const next = this.#queue.then(async () => {
      clearTimeout(this.#timer);
      const { width, height, frame } = options;
      this.#stage = this.#stageWith(frame ? 'none' : 'plain');
      const show = { levelsShown: Number.POSITIVE_INFINITY, showLeaves: true, view: 'shaded' } as const;
      const { packed, stems } = grown;
      this.#stage.take({ packed, stems, species, wind: STILL, show, dark, channel: null, ...(scene ? { scene } : {}) });
      const canvas = document.createElement('canvas');
      canvas.width = width;
      canvas.height = height;
      try {
        await this.#stage.draw(canvas, 0, frame ? frameView(frame, options) : 'close');
      } catch (error) {
        this.dispose();
        throw error;
      }
      this.#timer = setTimeout(() => this.dispose(), IDLE);
      return blobOf(canvas);
    });
    this.#queue = next.catch(() => {});
    return next;
  }

  /** The stage at hand, or another where that has the wrong things around the tree. */
  #stageWith(around: Setting): CaptureStage {
    if (this.#stage && this.#around === around) return this.#stage;
    this.dispose();
    this.#around = around;
    return new CaptureStage(around, new WindTree());
  }

  dispose(): void {
    clearTimeout(this.#timer);
    this.#stage?.dispose();
    this.#stage = null;
  }
}

const blobOf = (canvas: HTMLCanvasElement): Promise<Blob> =>
  new Promise((done, fail) => {
    canvas.toBlob(
      (blob) => (blob ? done(blob) : fail(new Error('The browser could not write the picture.'))),
      'image/webp',
      QUALITY,
    );
  });
