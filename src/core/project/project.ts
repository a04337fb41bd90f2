import { foundText } from '../file/allowed.ts';
import { type Fault, readJson } from '../file/fault.ts';
import { type Fields, fieldsOf, hasFormat, listOf, unknownKeys } from '../file/read.ts';
import { parseSpecies } from '../species/parse.ts';
import type { Species } from '../species/species.ts';
import { FieldReader } from './fields.ts';
import { LONGEST_PROJECT, LONGEST_SNAPSHOT_NAME, MOST_SNAPSHOTS } from './limits.ts';
import { DOCUMENT_KEYS, documentFields, type ProjectDocument, readDocument } from './project-document.ts';

/** A named state that travels in a project. */
export interface ProjectSnapshot {
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly when: number;
  /** As `encodeLink` writes it. */
  readonly link: string;
}

/** Everything of one tree: what it grew from, what was changed, its wind, how it is looked at, and named states. */
export interface Project {
  /** The species without the edits. */
  readonly species: Species;
  /** Id of the species that ships and that this is, or was when it was written; null: the reader's own. */
  readonly preset: string | null;
  readonly document: ProjectDocument;
  readonly snapshots: readonly ProjectSnapshot[];
}

export type ParsedProject =
  | { readonly project: Project; readonly faults?: undefined }
  | { readonly project?: undefined; readonly faults: readonly Fault[] };

/** Letters of a snapshot's link. */
const LONGEST_LINK = 1_000_000;
const LONGEST_ID = 80;
/** Milliseconds: the year 9999. */
const LATEST = 253_402_300_799_999;

/** The text of the project's file: one line a value, but what is small and belongs together on one. */
export function projectText({ species, preset, document, snapshots }: Project): string {
  const { name, ...rest } = documentFields(document);
  const file = { format: 'windgrove-project', version: 1, name, preset, species, ...rest, snapshots };
  const text = JSON.stringify(file, null, 2);
  // The innermost braces and brackets that are short: a wave, a gust, a camera's target.
  const flat = text.replace(/[{[]\n[^{}[\]]*[}\]]/g, (part) => {
    const line = part.replace(/\s*\n\s*/g, ' ');
    return line.length <= 200 ? line : part;
  });
  return `${flat}\n`;
}

/**
 * A project from the text of a file, or from what JSON.parse made of it; every fault where there are any, each with its path.
 *
 * The species must be there and be whole; whatever else is left out has its default. Edits that change nothing are left out. Never throws.
 */
export function parseProject(file: unknown): ParsedProject {
  if (typeof file !== 'string') return readProject(file);
  const { value, fault } = readJson(file, 'a project', LONGEST_PROJECT);
  return fault ? { faults: [fault] } : readProject(value);
}

function readProject(value: unknown): ParsedProject {
  const faults: Fault[] = [];
  const file = fieldsOf(value, '', faults);
  if (!file || !hasFormat(file, 'windgrove-project', faults)) return { faults };
  unknownKeys(file, '', ['format', 'version', '$schema', 'preset', 'species', ...DOCUMENT_KEYS, 'snapshots'], faults);
  const read = new FieldReader(file, '', faults);
  const species = readSpecies(read.value('species'), faults);
  const preset = file.preset === null ? null : read.text('preset', LONGEST_ID, '') || null;
  const document = readDocument(file, faults);
  const snapshots = readSnapshots(file, faults);
  return faults.length > 0 || !species ? { faults } : { project: { species, preset, document, snapshots } };
}

function readSpecies(value: unknown, faults: Fault[]): Species | null {
  // A text is no species here, even where it would be one.
  const parsed = parseSpecies(typeof value === 'string' ? [] : value);
  if (parsed.species) return parsed.species;
  for (const { path, found, allowed } of parsed.faults) {
    const at = path === '' ? 'species' : `species.${path}`;
    faults.push({ path: at, found: path === '' ? foundText(value) : found, allowed });
  }
  return null;
}

function readSnapshots(file: Fields, faults: Fault[]): ProjectSnapshot[] {
  if (file.snapshots === undefined) return [];
  const allowed = `a list of up to ${MOST_SNAPSHOTS} snapshots`;
  const list = listOf(file.snapshots, [0, MOST_SNAPSHOTS], 'snapshots', allowed, faults) ?? [];
  return list.flatMap((entry, i) => {
    const path = `snapshots[${i}]`;
    const fields = fieldsOf(entry, path, faults);
    if (!fields) return [];
    unknownKeys(fields, `${path}.`, ['name', 'when', 'link'], faults);
    const read = new FieldReader(fields, `${path}.`, faults);
    for (const key of ['name', 'link']) if (read.value(key) === undefined) read.fault(key, 'a text');
    return [
      {
        name: read.text('name', LONGEST_SNAPSHOT_NAME, '?'),
        when: read.number('when', { label: 'when', unit: '', min: 0, max: LATEST, decimals: 0 }, 0),
        link: read.text('link', LONGEST_LINK, '?'),
      },
    ];
  });
}
