import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { foundText } from '../core/file/allowed.ts';
import { type Fault, faultText, readJson } from '../core/file/fault.ts';
import { parseIndex } from '../core/file/shipped-index.ts';
import { parseSpecies } from '../core/species/parse.ts';
import { LONGEST_WIND } from '../core/wind/parse-wind.ts';
import { parseWindWithRecord } from '../core/wind/wind-with-record.ts';
import { Failure } from './failure.ts';
import { importerOf, readText } from './species-files.ts';
import type { Streams } from './streams.ts';

/** What a file is, and what is wrong with it. */
interface Checked {
  readonly kind: string;
  readonly faults: readonly Fault[];
  /** What an import could not carry over. */
  readonly notes?: readonly string[];
}

/** Checks files of species and winds, and lists of them; one line a file or a fault. Returns the exit status. */
export function validate(files: readonly string[], { out, err }: Streams): number {
  let status = 0;
  for (const file of files) {
    try {
      const { kind, faults, notes = [] } = check(file);
      if (faults.length === 0) {
        out(`${file}: a valid ${kind}`);
        for (const note of notes) out(`  ${note}`);
        continue;
      }
      for (const fault of faults) err(`${file}: ${faultText(fault)}`);
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
      err(error.message);
    }
    status = 1;
  }
  return status;
}

/** What the file says that it is decides how it is read: its format, or that it is a list. */
function check(file: string): Checked {
  const text = readText(file);
  const importer = importerOf(text);
  if (importer) {
    const imported = importer.parse(text);
    const kind = `tree of ${importer.program}`;
    return imported.faults ? { kind, faults: imported.faults } : { kind, faults: [], notes: imported.notes };
  }
  const { value, fault } = readJson(text, 'a species or a wind', LONGEST_WIND);
  if (fault) return { kind: '', faults: [fault] };
  if (Array.isArray(value)) return checkIndex(file, value);
  switch (formatOf(value)) {
    case 'windgrove-species':
      return { kind: 'species', faults: parseSpecies(value).faults ?? [] };
    case 'windgrove-wind': {
      const { faults } = parseWindWithRecord(value, (name) => readText(join(dirname(file), name)));
      return { kind: 'wind', faults: faults ?? [] };
    }
    default: {
      const found = foundText(typeof value === 'object' && value !== null ? formatOf(value) : value);
      const path = typeof value === 'object' && value !== null ? 'format' : '';
      return { kind: '', faults: [{ path, found, allowed: '"windgrove-species" or "windgrove-wind"' }] };
    }
  }
}

const formatOf = (value: unknown): unknown =>
  typeof value === 'object' && value !== null && 'format' in value ? value.format : undefined;

/** A list of files that ship: each that it names must be there. */
function checkIndex(file: string, value: readonly unknown[]): Checked {
  const { entries, faults } = parseIndex(value);
  if (faults) return { kind: '', faults };
  const missing = entries.flatMap((entry, i) =>
    (['file', 'thumbnail'] as const).flatMap((key) => {
      const name = entry[key];
      if (name === undefined || existsSync(join(dirname(file), name))) return [];
      return [{ path: `[${i}].${key}`, found: foundText(name), allowed: 'the name of a file beside this one' }];
    }),
  );
  return { kind: `list of ${entries.length} files`, faults: missing };
}
