import { parseSpecies } from '../core/species/parse.ts';
import type { Species } from '../core/species/species.ts';
import { FileError } from './file-error.ts';
import { fetchText } from './public-file.ts';
import type { SpeciesEntry } from './session.ts';
import { messageWords } from './words/messages.ts';

/** The species that ship. */
export async function loadIndex(): Promise<readonly SpeciesEntry[]> {
  return JSON.parse(await fetchText('species/index.json', messageWords.lists.species)) as SpeciesEntry[];
}

/** Reads the text of a species file; throws a FileError under `title` that says where it is wrong and what is allowed. */
export function readSpecies(text: string, title: string): Species {
  const { species, faults } = parseSpecies(text);
  if (species) return species;
  throw FileError.of(title, faults);
}

const shipped = new Map<string, Promise<Species>>();
const loaded = new Map<string, Species>();

/** A species that ships, by id, where it has been loaded. */
export const loadedSpecies = (id: string): Species | null => loaded.get(id) ?? null;

/** A species that ships; loaded once. */
export function loadSpecies(entry: SpeciesEntry): Promise<Species> {
  let loading = shipped.get(entry.id);
  if (!loading) {
    loading = fetchText(`species/${entry.file}`, entry.name).then((text) =>
      readSpecies(text, messageWords.cannotGrow(entry.name)),
    );
    loading.then(
      (species) => loaded.set(entry.id, species),
      () => shipped.delete(entry.id),
    );
    shipped.set(entry.id, loading);
  }
  return loading;
}
