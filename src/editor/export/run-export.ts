import type { ExportFile, ExportOptions } from '../../core/io/export-options.ts';
import type { Species } from '../../core/species/species.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { exportInWorker } from '../../view/picture/export-in-worker.ts';
import type { Picture } from '../../view/picture/picture.ts';
import { filmOf } from './film.ts';
import { isFormat, isPicture, type Kind } from './kinds.ts';
import type { PictureOptions } from './picture-options.ts';
import { takePng } from './png.ts';
import { takeSequence } from './sequence.ts';
import { takeVideo, videoKind } from './video.ts';

/** What is exported. */
export interface Subject {
  readonly species: Species;
  readonly seed: number;
  /** What blows, still air where the wind is off. */
  readonly wind: Wind;
  /** Seconds: the time that is shown. */
  readonly time: number;
  readonly picture: Picture;
  /** Bare name of the files: `quaking-aspen-3`. */
  readonly name: string;
}

/** What a run is at: a stage by name, the part of all that is done, and of films the frame. */
export interface Progress {
  readonly stage: string;
  readonly done: number;
  readonly frame?: { readonly done: number; readonly all: number };
}

/** A file that is ready to be saved. */
export interface Result {
  readonly name: string;
  readonly blob: Blob;
}

/** This browser can encode no video of that size in that format. */
export class NoEncoder extends Error {
  override readonly name = 'NoEncoder';
}

/** Makes the file of a kind. Rejects with the signal's reason, NoEncoder, or whatever makes it says. */
export async function runExport(
  kind: Kind,
  subject: Subject,
  choices: ExportOptions | PictureOptions,
  signal: AbortSignal,
  onProgress: (progress: Progress) => void,
): Promise<Result> {
  if (isPicture(kind)) return takePicture(kind, subject, choices as PictureOptions, signal, onProgress);
  if (!isFormat(kind)) throw new RangeError(`There is no export as "${kind}".`);
  const { species, seed, wind, name } = subject;
  const files = await exportInWorker(species, seed, wind, choices as ExportOptions, { signal, onProgress });
  signal.throwIfAborted();
  return packed(files, name);
}

/** One file as it is, several as an archive. */
async function packed(files: readonly ExportFile[], name: string): Promise<Result> {
  const [first] = files;
  if (!first) throw new Error('The export gave no file.');
  if (files.length === 1) return { name: first.name, blob: new Blob([first.bytes], { type: first.type }) };
  const { zip } = await import('fflate');
  const entries = Object.fromEntries(files.map((file) => [file.name, file.bytes]));
  const bytes = await new Promise<Uint8Array>((done, fail) =>
    zip(entries, { level: 6 }, (error, data) => (error ? fail(error) : done(data))),
  );
  return { name: `${name}.zip`, blob: new Blob([bytes as Uint8Array<ArrayBuffer>], { type: 'application/zip' }) };
}

async function takePicture(
  kind: 'picture' | 'sequence' | 'video',
  { picture, wind, time, name }: Subject,
  options: PictureOptions,
  signal: AbortSignal,
  onProgress: (progress: Progress) => void,
): Promise<Result> {
  const even = kind === 'video';
  // Encoders work on blocks of two by two pixels.
  const [width, height] = [options.width, options.height].map((side) => (even ? side - (side % 2) : side)) as [
    number,
    number,
  ];
  const size = `${width}x${height}`;
  onProgress({ stage: 'open', done: 0 });
  const encoder = even ? await videoKind({ width, height }, options.container) : null;
  if (even && !encoder) throw new NoEncoder();
  const film = filmOf(wind, time, kind === 'picture' ? { ...options, loop: false } : options);
  const capture = await picture.openCapture({
    width,
    height,
    transparent: kind !== 'video' && options.transparent,
    wind: film.wind,
  });
  const all = film.times.length;
  const onFrame = (done: number): void => onProgress({ stage: 'frames', done: done / all, frame: { done, all } });
  try {
    if (kind === 'picture') return { name: `${name}-${size}.png`, blob: await takePng(capture, time, signal) };
    onFrame(0);
    if (kind === 'sequence') {
      return {
        name: `${name}-${size}-frames.zip`,
        blob: await takeSequence(capture, film.times, name, signal, onFrame),
      };
    }
    const blob = await takeVideo(capture, film.times, encoder!, options, signal, onFrame);
    return { name: `${name}-${size}.${encoder!.container}`, blob };
  } finally {
    capture.close();
  }
}
