import { SPECIES_KINDS, type SpeciesKind } from '../../core/species/species.ts';
import { fits, plain } from '../fuzzy.ts';
import type { SpeciesEntry } from '../session.ts';
import { galleryWords } from '../words/gallery.ts';

/** The kinds that there are, in their order. */
export const kindsOf = (species: readonly SpeciesEntry[]): readonly SpeciesKind[] =>
  SPECIES_KINDS.filter((kind) => species.some((each) => each.kind === kind));

/** The species of a kind, null: of any, whose name, Latin name or kind fits a query; in their order. */
export function findSpecies(
  species: readonly SpeciesEntry[],
  query: string,
  kind: SpeciesKind | null,
): readonly SpeciesEntry[] {
  const asked = plain(query);
  return species.filter((each) => {
    if (kind !== null && each.kind !== kind) return false;
    const text = `${each.name} ${each.latin} ${each.kind ? galleryWords.kinds[each.kind] : ''}`;
    return asked === '' || fits(asked, plain(text)) >= 1;
  });
}
