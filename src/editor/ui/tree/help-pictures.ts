import type { ParameterValue } from '../../../core/species/edits.ts';
import { fetchText } from '../../public-file.ts';

/** Values that the two pictures of a parameter show. */
export interface PictureValues {
  readonly low: ParameterValue;
  readonly high: ParameterValue;
}

let loading: Promise<Readonly<Record<string, PictureValues>>> | null = null;

/** The parameters that have pictures, by path without the level; none where the list cannot be read. Loaded once. */
export function loadPictures(): Promise<Readonly<Record<string, PictureValues>>> {
  loading ??= fetchText('help/index.json', 'The list of help pictures')
    .then((text) => JSON.parse(text) as Record<string, PictureValues>)
    .catch(() => ({}));
  return loading;
}

/** A path as the pictures are named: without the level, and autumn for every season that changes the look. */
export const pictureName = (path: string): string =>
  path.replace(/^levels\.\d+\./, 'levels.').replace(/^(spring|winter)\./, 'autumn.');
