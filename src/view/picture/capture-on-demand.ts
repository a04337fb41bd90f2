import { WindTree } from '../wind-tree.ts';
import type { Sitter, Viewpoint } from './capture-stage.ts';
import type { Capture, CaptureOptions } from './picture.ts';
import type { Portraits } from './portraits.ts';

// What draws beside the picture is loaded when it is first asked for: a tree stands before.

/** As `openCapture` of capture.ts. */
export const openCapture = async (sitter: Sitter, from: Viewpoint, options: CaptureOptions): Promise<Capture> =>
  (await import('./capture.ts')).openCapture(sitter, from, options, () => new WindTree());

let portraits: Promise<Portraits> | null = null;

/** As `Portraits.take`, on the one stage that all portraits of the page share. */
export async function takePortrait(...given: Parameters<Portraits['take']>): Promise<Blob> {
  portraits ??= import('./portraits.ts').then((module) => new module.Portraits());
  // What could not be loaded may be tried again.
  portraits.catch(() => {
    portraits = null;
  });
  return (await portraits).take(...given);
}
