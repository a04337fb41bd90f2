import type { FoliageLook, OrganLook, SeasonLook, Species } from './species.ts';

export const SEASONS = ['spring', 'summer', 'autumn', 'winter'] as const;
export type Season = (typeof SEASONS)[number];

/** The value of a season where it has one, else that of summer; a key that neither has stays absent. */
function changed(foliage: FoliageLook, { cover, colour, second, secondShare, under, glow }: SeasonLook): FoliageLook {
  const said = Object.entries({ cover, colour, second, secondShare, under, glow }).filter(
    ([, value]) => value !== undefined,
  );
  return said.length === 0 ? foliage : { ...foliage, ...Object.fromEntries(said) };
}

function bearing(organ: OrganLook, { organ: kind, organShare, organSize, organColour }: SeasonLook): OrganLook {
  return {
    ...organ,
    kind: kind ?? organ.kind,
    share: organShare ?? organ.share,
    size: organSize ?? organ.size,
    colour: organColour ?? organ.colour,
  };
}

/**
 * The species as it looks in a season: foliage and organs replaced by what the season says of them, everything else shared, so that
 * the same tree stands in it. Summer is the species itself.
 */
export function inSeason(species: Species, season: Season): Species {
  if (season === 'summer') return species;
  const look = species[season];
  if (Object.keys(look).length === 0) return species;
  return { ...species, foliage: changed(species.foliage, look), organ: bearing(species.organ, look) };
}

/** Whether any season but summer changes how the species looks. */
export const hasSeasons = ({ spring, autumn, winter }: Species): boolean =>
  [spring, autumn, winter].some((look) => Object.keys(look).length > 0);
