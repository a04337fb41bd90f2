import { faultText } from '../core/file/fault.ts';
import { type ExportOptions, readExportOptions } from '../core/io/export-options.ts';
import type { CameraPose } from '../core/link/document.ts';
import { inSeason, type Season } from '../core/species/season.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { KitTree } from '../view/kit-tree.ts';
import { openCapture } from '../view/picture/capture.ts';
import { exportInWorker } from '../view/picture/export-in-worker.ts';
import type { GrownTree } from '../worker/client.ts';
import { STAGE_OF } from './attributes.ts';
import { elementKit } from './element-kit.ts';
import type { TreeLook } from './tree-look.ts';

/** What an element shows. */
export interface Shown {
  readonly grown: GrownTree;
  readonly species: Species;
  readonly wind: Wind;
  readonly season: Season;
  readonly seed: number;
}

/** How a picture of it is to be; what is not said is as on the screen. */
export interface WantedPicture {
  /** Pixels. */
  readonly width?: number;
  readonly height?: number;
  /** Media type, `image/png` by default. */
  readonly type?: string;
  /** Of lossy types, 0..1. */
  readonly quality?: number;
  /** Seconds. */
  readonly time?: number;
}

/** What is on the screen: its size in CSS pixels, of which as much is in the picture, its time and its camera. */
export interface OnScreen {
  readonly width: number;
  readonly height: number;
  readonly time: number;
  readonly camera: CameraPose;
  readonly look: TreeLook;
}

/** A picture at a size of its own, on a stage of its own: what is on the screen stays as it is. Rejects where the browser cannot. */
export async function takePicture(shown: Shown, wanted: WantedPicture, screen: OnScreen): Promise<Blob> {
  const { grown, species, wind, season } = shown;
  const { camera, look } = screen;
  const [wide, high] = [Math.max(1, screen.width), Math.max(1, screen.height)];
  const { width = wide, height = high, type = 'image/png', quality, time = screen.time } = wanted;
  if (!(time >= 0 && time < Number.POSITIVE_INFINITY))
    throw new RangeError(`A picture is of a time from 0 s on; found ${time}.`);
  const { environment, hour, levels, leaves, dark } = look;
  const dressed = inSeason(species, season);
  // The season may have changed a moment ago.
  await elementKit.load(dressed);
  const capture = openCapture(
    {
      packed: grown.packed,
      stems: grown.stems,
      species: dressed,
      wind,
      show: { levelsShown: levels, showLeaves: leaves, view: 'shaded' },
      dark,
      channel: null,
      scene: { stage: STAGE_OF[environment], hour },
    },
    { pose: camera, high: 1, wide: wide / high },
    { width, height, transparent: environment === 'none' },
    () => new KitTree(elementKit),
  );
  try {
    await capture.draw(time);
    const { canvas } = capture;
    if (!(canvas instanceof HTMLCanvasElement)) return await canvas.convertToBlob({ type, quality });
    return await new Promise((done, fail) =>
      canvas.toBlob(
        (blob) => (blob ? done(blob) : fail(new Error(`The browser could not write the picture as ${type}.`))),
        type,
        quality,
      ),
    );
  } finally {
    capture.close();
  }
}

/** The tree as a GLB file. Throws RangeError where an option is none, and rejects as the export does. */
export async function writeGlb(
  { species, seed, wind, season }: Shown,
  given: Partial<ExportOptions>,
  signal?: AbortSignal,
): Promise<Blob> {
  const { options, faults } = readExportOptions({ season, ...given, format: 'glb' });
  if (faults) throw new RangeError(faults.map(faultText).join(' '));
  const [file] = await exportInWorker(species, seed, wind, options, signal ? { signal } : {});
  if (!file) throw new Error('The export gave no file.');
  return new Blob([file.bytes], { type: file.type });
}
