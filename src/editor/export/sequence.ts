import type { Capture } from '../../view/picture/picture.ts';
import { pngOf } from './png.ts';

/** Bytes that are held before they go into a Blob, which the browser may keep on disk. */
const HELD = 16 * 1024 * 1024;

/** The name of a frame in the archive: numbered from 1, so that programs sort them as they come. */
export const frameName = (name: string, index: number, count: number): string =>
  `${name}-${String(index + 1).padStart(Math.max(4, String(count).length), '0')}.png`;

/**
 * One PNG for each time, in a zip archive.
 *
 * One frame at a time is in memory; the archive grows in Blobs. Rejects with the signal's reason, and leaves nothing behind.
 */
export async function takeSequence(
  capture: Capture,
  times: readonly number[],
  name: string,
  signal: AbortSignal,
  onFrame: (done: number) => void,
): Promise<Blob> {
  const { Zip, ZipPassThrough } = await import('fflate');
  const blobs: Blob[] = [];
  let held: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  const letGo = (): void => {
    blobs.push(new Blob(held));
    held = [];
    size = 0;
  };
  let failed: Error | null = null;
  const zip = new Zip((error, chunk) => {
    if (error) failed = error;
    held.push(chunk as Uint8Array<ArrayBuffer>);
    size += chunk.length;
    if (size > HELD) letGo();
  });
  for (const [i, time] of times.entries()) {
    signal.throwIfAborted();
    await capture.draw(time);
    const bytes = new Uint8Array(await (await pngOf(capture.canvas)).arrayBuffer());
    signal.throwIfAborted();
    // A PNG is compressed already.
    const entry = new ZipPassThrough(frameName(name, i, times.length));
    zip.add(entry);
    entry.push(bytes, true);
    if (failed) throw failed;
    onFrame(i + 1);
  }
  zip.end();
  letGo();
  return new Blob(blobs, { type: 'application/zip' });
}
