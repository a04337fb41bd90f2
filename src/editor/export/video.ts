import type { VideoCodec } from 'mediabunny';
import type { Capture } from '../../view/picture/picture.ts';
import type { PictureOptions } from './picture-options.ts';

/** What this browser writes a video as. */
export interface VideoKind {
  readonly container: 'mp4' | 'webm';
  readonly codec: VideoCodec;
}

/** What is tried, best first: what plays widely, then what is small. */
const KINDS: readonly VideoKind[] = [
  { container: 'mp4', codec: 'avc' },
  { container: 'webm', codec: 'vp9' },
  { container: 'webm', codec: 'av1' },
  { container: 'mp4', codec: 'av1' },
  { container: 'webm', codec: 'vp8' },
  { container: 'mp4', codec: 'hevc' },
];

/** The first kind of video that this browser can encode in this size; null: none. */
export async function videoKind(
  { width, height }: { readonly width: number; readonly height: number },
  container: PictureOptions['container'],
): Promise<VideoKind | null> {
  if (typeof VideoEncoder === 'undefined') return null;
  const { canEncodeVideo } = await import('mediabunny');
  for (const kind of KINDS) {
    if (container !== 'auto' && kind.container !== container) continue;
    if (await canEncodeVideo(kind.codec, { width, height })) return kind;
  }
  return null;
}

/**
 * A video with a frame for each time, at even steps of 1 / rate seconds from 0.
 *
 * Frames wait until the encoder has room. Rejects with the signal's reason, or with what the encoder says, and leaves nothing behind.
 */
export async function takeVideo(
  capture: Capture,
  times: readonly number[],
  kind: VideoKind,
  { rate, quality }: Pick<PictureOptions, 'rate' | 'quality'>,
  signal: AbortSignal,
  onFrame: (done: number) => void,
): Promise<Blob> {
  const { BufferTarget, CanvasSource, Mp4OutputFormat, Output, Quality, WebMOutputFormat } = await import('mediabunny');
  signal.throwIfAborted();
  const format = kind.container === 'mp4' ? new Mp4OutputFormat({ fastStart: 'in-memory' }) : new WebMOutputFormat();
  const target = new BufferTarget();
  const output = new Output({ format, target });
  try {
    const source = new CanvasSource(capture.canvas, { codec: kind.codec, quality: new Quality(quality) });
    output.addVideoTrack(source, { frameRate: rate });
    await output.start();
    for (const [i, time] of times.entries()) {
      signal.throwIfAborted();
      await capture.draw(time);
      await source.add(i / rate, 1 / rate);
      onFrame(i + 1);
    }
    signal.throwIfAborted();
    await output.finalize();
  } catch (error) {
    await output.cancel();
    throw error;
  }
  if (!target.buffer) throw new Error('The encoder gave no video.');
  return new Blob([target.buffer], { type: kind.container === 'mp4' ? 'video/mp4' : 'video/webm' });
}
