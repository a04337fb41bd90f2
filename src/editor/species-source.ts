import { faultText, parseSpecies } from '../core/species/parse.ts';
import type { Species } from '../core/species/species.ts';
import type { SpeciesEntry } from './session.ts';

/** Longest species file that is read: a good one has 4 kB. */
const LONGEST = 1_000_000;

/** Something about a species that the reader must know; `lines` say where, what was found, what is allowed. */
export class SpeciesError extends Error {
  override readonly name = 'SpeciesError';
  readonly lines: readonly string[];
  constructor(title: string, lines: readonly string[] = []) {
    super(title);
    this.lines = lines;
  }
}

/** Where a file of `public/` lies, wherever the page does. */
const publicUrl = (path: string): URL => new URL(path, document.baseURI);

async function fetchText(path: string, what: string): Promise<string> {
  const url = publicUrl(path);
  const response = await fetch(url).catch((error: unknown) => {
    throw new SpeciesError(`${what} could not be loaded`, [
      `${url.pathname}: ${String(error)}`,
      'Is the connection up? Reload the page to try again.',
    ]);
  });
  if (!response.ok)
    throw new SpeciesError(`${what} could not be loaded`, [
      `${url.pathname}: the server says ${response.status} ${response.statusText}`,
    ]);
  return response.text();
}

/** The species that ship. */
export async function loadIndex(): Promise<readonly SpeciesEntry[]> {
  return JSON.parse(await fetchText('species/index.json', 'The list of species')) as SpeciesEntry[];
}

/** Faults that a message lists; a file of another kind has hundreds. */
const LISTED = 8;

/** Reads the text of a species file; throws a SpeciesError under `title` that says where it is wrong and what is allowed. */
export function readSpecies(text: string, title: string): Species {
  const { species, faults } = parseSpecies(text);
  if (species) return species;
  const more = faults.length - LISTED;
  throw new SpeciesError(title, [
    ...faults.slice(0, LISTED).map(faultText),
    ...(more > 0 ? [`${more} more like these.`] : []),
  ]);
}

const shipped = new Map<string, Promise<Species>>();

/** A species that ships; loaded once. */
export function loadSpecies(entry: SpeciesEntry): Promise<Species> {
  let loading = shipped.get(entry.id);
  if (!loading) {
    loading = fetchText(`species/${entry.file}`, entry.name).then((text) =>
      readSpecies(text, `${entry.name} cannot be grown`),
    );
    loading.catch(() => shipped.delete(entry.id));
    shipped.set(entry.id, loading);
  }
  return loading;
}

/** The text of a file of the reader's own, checked: what comes back is a species that can be grown. */
export async function readOwnFile(file: File): Promise<string> {
  if (file.size > LONGEST) {
    throw new SpeciesError(`${file.name} is no species file`, [
      `It has ${file.size} bytes; at most ${LONGEST} are read.`,
    ]);
  }
  const text = await file.text();
  readSpecies(text, `${file.name} was not opened`);
  return text;
}
