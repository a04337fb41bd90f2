import { ownSeasons, type Season } from './season.ts';
import type { Range, Species, SpeciesKind } from './species.ts';

/** What the list of the species that ship says of one, so that a gallery need not read every file. */
export interface ShippedFacts {
  readonly kind?: SpeciesKind;
  /** Metres, least and most of grown trees. */
  readonly height?: Range;
  /** The seasons in which it looks otherwise than in summer. */
  readonly seasons: readonly Season[];
}

/** What the list says of a species: its file is what counts. */
export function shippedFacts(species: Species): ShippedFacts {
  const { facts } = species;
  return { ...(facts ? { kind: facts.kind, height: facts.height } : {}), seasons: ownSeasons(species) };
}
