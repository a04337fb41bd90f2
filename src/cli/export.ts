import { existsSync, statSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import { exportTree, fileName } from '../core/io/export-tree.ts';
import { foreseen } from './foreseen.ts';
import { exportOptionsOf, type FlagValues, formatOf } from './option-flags.ts';
import { findSpecies } from './species-files.ts';
import type { Streams } from './streams.ts';
import { DEFAULT_WIND, findWind } from './wind-files.ts';
import { writeWhole } from './write-file.ts';

/** What `windgrove export` was asked for. */
export interface ExportCall {
  readonly species: string;
  readonly seed: number;
  readonly format: string | undefined;
  /** A file, or a folder where it ends in a slash or is one; the files' own names here where there is none. */
  readonly out: string | undefined;
  readonly wind: string | undefined;
  readonly flags: FlagValues;
}

/** Writes one tree; says which files it made. */
export async function exportCommand(call: ExportCall, { out, err, progress }: Streams): Promise<number> {
  const format = formatOf(call.format, call.out);
  const options = exportOptionsOf(call.flags, format);
  const { species } = findSpecies(call.species, err);
  const { wind } = findWind(call.wind ?? DEFAULT_WIND);
  const place = placeOf(call.out, fileName(species.name, call.seed));
  const files = await foreseen(() =>
    exportTree(species, call.seed, wind, options, (stage, done) => progress?.(`${stage} ${Math.round(100 * done)} %`), {
      name: place.name,
    }),
  );
  progress?.('');
  files.forEach((file, i) => {
    // The first file is what was asked for; what it needs lies beside it.
    const path = join(place.folder, i === 0 && place.file ? place.file : file.name);
    writeWhole(path, file.bytes);
    out(`${path}: ${file.bytes.length} bytes`);
  });
  return 0;
}

/** Where files go, and the bare name that they have there. */
function placeOf(out: string | undefined, name: string): { folder: string; name: string; file?: string } {
  if (out === undefined) return { folder: '', name };
  if (/[/\\]$/.test(out) || (existsSync(out) && statSync(out).isDirectory())) return { folder: out, name };
  const file = basename(out);
  return { folder: join(out, '..'), name: basename(file, extname(file)), file };
}
