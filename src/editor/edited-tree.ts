import { type ParameterValue, type SpeciesEdits, valueAt, withEdit } from '../core/species/edits.ts';
import type { Species } from '../core/species/species.ts';
import type { DocumentStore } from './document-store.ts';
import type { SessionStore } from './session.ts';

/** The species that the document's edits are of; null while it is loading or growing for the first time. */
export function baseOf(document: DocumentStore, session: SessionStore): Species | null {
  const { tree } = session.getState();
  if (!tree) return null;
  const { species, ownSpecies } = document.getState();
  const { source } = tree;
  return !source || (source.species === species && source.ownSpecies === ownSpecies) ? tree.base : null;
}

/** The edits with some more in them; what is as in the base is none. Without a base, all are kept. */
export function withEdits(
  base: Species | null,
  edits: SpeciesEdits,
  more: Readonly<Record<string, ParameterValue>>,
): SpeciesEdits {
  if (!base) return { ...edits, ...more };
  return Object.entries(more).reduce((all, [path, value]) => withEdit(base, all, path, value), edits);
}

/** The value that a parameter has now: that of the edits, else that of the base. */
export const presentValue = (base: Species, edits: SpeciesEdits, path: string): ParameterValue =>
  Object.hasOwn(edits, path) ? edits[path]! : valueAt(base, path);
