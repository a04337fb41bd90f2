import { seedOf } from '../core/file/shipped-index.ts';
import type { Season } from '../core/species/season.ts';
import type { Doing } from './doing.ts';
import { embedSnippet } from './embed-snippet.ts';
import type { SpeciesEntry } from './session.ts';
import { fileWords } from './words/files.ts';

/** What a reader can do in the gallery. */
export function galleryActions(
  { session, services, set }: Doing,
  { setSpecies }: { readonly setSpecies: (species: string) => void },
) {
  return {
    /** Opens the gallery, at the page of a species where one is named. */
    openGallery: (speciesPage: string | null = null) => session.setState({ dialog: 'gallery', speciesPage }),
    /** Turns to the page of a species in the open gallery, or back to all. */
    showSpeciesPage: (speciesPage: string | null) => session.setState({ speciesPage }),
    /** Grows a species as its picture shows it, and closes the gallery. */
    takeSpecies(entry: SpeciesEntry, season: Season): void {
      setSpecies(entry.id);
      set({ seed: seedOf(entry), season });
      session.setState({ dialog: null });
    },
    /** Copies what shows a species in another page; the snippet where the browser does not let it, else null. */
    async copySpeciesEmbed(entry: SpeciesEntry, season: Season): Promise<string | null> {
      const tree = {
        species: entry.id,
        ownSpecies: null,
        treeName: null,
        edits: {},
        seed: seedOf(entry),
        season,
        probe: null,
        compare: null,
        camera: null,
      };
      const address = services.addressOf({ ...services.now(), ...tree });
      const snippet = embedSnippet(address, fileWords.embedTitle(entry.name));
      return services.copy(snippet).then(
        () => null,
        () => snippet,
      );
    },
  };
}
