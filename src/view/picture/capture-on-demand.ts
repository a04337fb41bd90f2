import type { openCapture as Open } from './capture.ts';
import type { Capture } from './picture.ts';
import type { Portraits } from './portraits.ts';

// What draws beside the picture is loaded when it is first asked for: a tree stands before.

/** As `openCapture` of capture.ts. */
export const openCapture = async (...given: Parameters<typeof Open>): Promise<Capture> =>
  (await import('./capture.ts')).openCapture(...given);

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
