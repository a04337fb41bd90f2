import type { Capture } from '../../view/picture/picture.ts';

/** What is on a canvas as a PNG; where it is transparent with straight alpha. Rejects where the browser cannot write it. */
export const pngOf = (canvas: Capture['canvas']): Promise<Blob> =>
  canvas instanceof HTMLCanvasElement
    ? new Promise((done, fail) => {
        canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error('The browser could not write the picture.'))));
      })
    : canvas.convertToBlob({ type: 'image/png' });

/** One picture at `time` seconds. The capture stays open. */
export async function takePng(capture: Capture, time: number, signal: AbortSignal): Promise<Blob> {
  signal.throwIfAborted();
  await capture.draw(time);
  signal.throwIfAborted();
  return pngOf(capture.canvas);
}
