import { parseSpecies } from '../core/species/parse.ts';
import type { Species } from '../core/species/species.ts';
import type { Names } from './history-label.ts';
import type { Made } from './made.ts';
import type { SessionStore } from './session.ts';
import { loadedSpecies } from './species-source.ts';
import { stepWords } from './words/history.ts';

const own = new Map<string, Species | null>();

/** A species file of the reader's own; read once. */
function ownSpecies(text: string): Species | null {
  let species = own.get(text);
  if (species === undefined) {
    species = parseSpecies(text).species ?? null;
    own.set(text, species);
  }
  return species;
}

const base = ({ species, ownSpecies: text }: Made): Species | null =>
  text === null ? loadedSpecies(species) : ownSpecies(text);

/** What the labels of the history need to know of species, as far as the page knows it. */
export const namesIn = (session: SessionStore): Names => ({
  base,
  species: (made) =>
    base(made)?.name ??
    session.getState().species.find(({ id }) => made.ownSpecies === null && id === made.species)?.name ??
    stepWords.ownSpecies,
});
