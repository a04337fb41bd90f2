import { editSpecies } from '../../core/species/edits.ts';
import type { Species } from '../../core/species/species.ts';
import { baseOf } from '../edited-tree.ts';
import type { Editor } from '../editor.ts';

/** The species as it is edited now; null until a tree stands. */
export function presentSpecies({ document, session }: Editor): Species | null {
  const base = baseOf(document, session);
  return base && editSpecies(base, document.getState().edits);
}
