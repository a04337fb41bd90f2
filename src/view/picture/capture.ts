import type { KitTree } from '../kit-tree.ts';
import { CaptureStage, type Sitter, type Viewpoint } from './capture-stage.ts';
import type { Capture, CaptureOptions, PictureSize } from './picture.ts';

/** Longest side of a picture in pixels, and most pixels: what browsers agree to hold in a canvas. */
const LONGEST = 16_384;
const MOST = 2 ** 27;

/** A picture that is asked for is larger than the browser can make it. */
export class CaptureTooLarge extends Error {
  override readonly name = 'CaptureTooLarge';
  /** Pixels of the longest side that a picture of this shape may have. */
  readonly most: number;

  constructor(most: number) {
    super(`The picture may have at most ${most} pixels on its longer side.`);
    this.most = most;
  }
}

/** The longest side in pixels that a picture of this shape may have. */
export function mostPixels({ width, height }: PictureSize): number {
  const part = Math.min(width, height) / Math.max(width, height);
  return Math.floor(Math.min(LONGEST, Math.sqrt(MOST / part)));
}

/**
 * Opens a drawing of a tree at a size of its own, on a stage of its own. `tree`: what makes the object that is drawn.
 *
 * Throws RangeError where a side is no whole number of pixels, CaptureTooLarge, and what the browser says where it gives no context.
 */
export function openCapture(
  sitter: Sitter,
  from: Viewpoint,
  { width, height, transparent, shot = null }: CaptureOptions,
  tree: () => KitTree,
): Capture {
  for (const side of [width, height]) {
    if (!Number.isInteger(side) || side < 1)
      throw new RangeError(`A picture has whole pixels, at least 1; found ${side}.`);
  }
  const most = mostPixels({ width, height });
  if (Math.max(width, height) > most) throw new CaptureTooLarge(most);
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const stage = new CaptureStage(transparent ? 'none' : 'stage', tree());
  stage.take(sitter);
  stage.shot = shot;
  let drawing: Promise<void> = Promise.resolve();
  let closed = false;
  return {
    canvas,
    draw(time) {
      // One after the other: they share the stage.
      const next = drawing.then(() => {
        if (closed) throw new Error('This capture has been closed.');
        return stage.draw(canvas, time, from);
      });
      drawing = next.catch(() => {});
      return next;
    },
    close() {
      if (closed) return;
      closed = true;
      void drawing.then(() => stage.dispose());
    },
  };
}
