import type { ExportFormat, ExportOptions, ExportParameter } from '../../core/io/export-options.ts';
import { DEFAULT_EXPORT, exportParametersOf, readExportOptions } from '../../core/io/export-options.ts';
import type { Preferences } from '../preferences.ts';
import {
  PICTURE_PARAMETERS,
  type PictureKind,
  type PictureOptions,
  type PictureParameter,
  readPictureOptions,
} from './picture-options.ts';

/** What can be taken, in the order of the list: files of the tree, then what a camera sees. */
export const KINDS = ['glb', 'channels', 'obj', 'swc', 'species', 'project', 'picture', 'sequence', 'video'] as const;
export type Kind = (typeof KINDS)[number];

/** Kinds that stand under one heading. */
export const SECTIONS = [
  { name: 'model', kinds: ['glb', 'obj', 'channels'] },
  { name: 'data', kinds: ['swc', 'species', 'project'] },
  { name: 'camera', kinds: ['picture', 'sequence', 'video'] },
] as const satisfies readonly { name: string; kinds: readonly Kind[] }[];

export const isPicture = (kind: Kind): kind is PictureKind =>
  kind === 'picture' || kind === 'sequence' || kind === 'video';

export const isFormat = (kind: Kind): kind is ExportFormat => !isPicture(kind) && kind !== 'project';

/** A row of any of the tables. */
export type Row = ExportParameter | PictureParameter;

/** The rows of a kind; those of a clip only where there is one. */
export function rowsOf(kind: Kind, choices: Readonly<Record<string, unknown>>): readonly Row[] {
  if (isPicture(kind)) return PICTURE_PARAMETERS.filter((row) => row.kinds.includes(kind));
  if (!isFormat(kind)) return [];
  const clipped = new Set(['boneLevels', 'start', 'seconds', 'rate']);
  const noLeaves = choices.leaves === 'none';
  // No row for the season: it is that of the picture.
  return exportParametersOf(kind).filter(
    ({ key }) =>
      key !== 'season' && (choices.clip === true || !clipped.has(key)) && !(noLeaves && key === 'mostLeaves'),
  );
}

/** What was chosen last for a kind, where that may still be; defaults elsewhere. */
export function choicesOf(kind: Kind, { exports }: Pick<Preferences, 'exports'>): ExportOptions | PictureOptions {
  const given = exports[kind] ?? {};
  if (isPicture(kind)) return readPictureOptions(given);
  if (!isFormat(kind)) return DEFAULT_EXPORT;
  const rows = exportParametersOf(kind).filter(({ key }) => Object.hasOwn(given, key));
  const read = readExportOptions({ ...Object.fromEntries(rows.map(({ key }) => [key, given[key]])), format: kind });
  return read.options ?? { ...DEFAULT_EXPORT, format: kind };
}
