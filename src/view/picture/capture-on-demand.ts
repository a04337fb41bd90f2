import type { openCapture as Open } from './capture.ts';
import type { Portraits } from './portraits.ts';

// What draws beside the picture is loaded when it is first asked for: a tree stands before.

/** As `openCapture` of capture.ts. */
export const openCapture = async (...given: Parameters<typeof Open>): Promise<Awaited<ReturnType<typeof Open>>> =>
  (await import('./capture.ts')).openCapture(...given);

let portraits: Promise<Portraits> | null = null;

/** As `Portraits.take`, on the one stage that all portraits of the page share. */
export async function takePortrait(...given: Parameters<Portraits['take']>): Promise<Blob> {
  portraits ??= import('./portraits.ts').then((module) => new module.Portraits());
  return (await portraits).take(...given);
}
