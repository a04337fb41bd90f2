import { type LinkDocument, OWN_WIND, type Theme } from '../core/link/link.ts';
import { type Project, parseProject } from '../core/project/project.ts';
import { type ParameterValue, withEdit } from '../core/species/edits.ts';
import type { Species } from '../core/species/species.ts';
import { FileError } from './file-error.ts';
import { differences } from './made.ts';
import type { Session } from './session.ts';
import { loadSpecies } from './species-source.ts';

/** Reads the text of a project file; throws a FileError under `title` that says where it is wrong and what is allowed. */
export function readProject(text: string, title: string): Project {
  const { project, faults } = parseProject(text);
  if (project) return project;
  throw FileError.of(title, faults);
}

/** The species that ships and that the project is of; null where it ships no more or was changed since. */
async function shippedSpecies({ preset, species }: Project, { species: entries }: Pick<Session, 'species'>) {
  const entry = entries.find(({ id }) => id === preset);
  if (!entry) return null;
  const shipped = await loadSpecies(entry).catch((): Species | null => null);
  return shipped && differences(shipped, species).length === 0 ? entry.id : null;
}

/** The document that a project holds. */
export async function documentOfProject(
  project: Project,
  session: Pick<Session, 'species' | 'winds'>,
  theme: Theme,
): Promise<LinkDocument> {
  const { species, document } = project;
  const shipped = await shippedSpecies(project, session);
  const ships = (preset: string): string => (session.winds.some(({ id }) => id === preset) ? preset : OWN_WIND);
  const edits = Object.entries(document.edits).reduce(
    (all, [path, value]: [string, ParameterValue]) => withEdit(species, all, path, value),
    {},
  );
  return {
    ...document,
    species: shipped ?? session.species[0]?.id ?? '',
    ownSpecies: shipped === null ? JSON.stringify(species, null, 2) : null,
    edits,
    preset: ships(document.preset),
    compare: document.compare && { ...document.compare, preset: ships(document.compare.preset) },
    theme,
  };
}
