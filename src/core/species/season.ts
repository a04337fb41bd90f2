import type { FoliageLook, OrganLook, SeasonLook, Species } from './species.ts';

export const SEASONS = ['spring', 'summer', 'autumn', 'winter'] as const;
export type Season = (typeof SEASONS)[number];

/** Is this the path of what a season says, such as `autumn.colour`? */
export const isOfSeason = (path: string): boolean => /^(spring|autumn|winter)\./.test(path);

/** What a season may say, and the value of summer that it replaces there. */
const OF_FOLIAGE: Readonly<Partial<Record<keyof SeasonLook, keyof FoliageLook>>> = {
  cover: 'cover',
  colour: 'colour',
  second: 'second',
  secondShare: 'secondShare',
  under: 'under',
  glow: 'glow',
};
const OF_ORGAN: Readonly<Partial<Record<keyof SeasonLook, keyof OrganLook>>> = {
  organ: 'kind',
  organShare: 'share',
  organSize: 'size',
  organColour: 'colour',
};

/** The path of the value of summer that `key` of a season replaces: `organ.kind` for `organ`, `foliage.cover` for `cover`. */
export function summerPath(key: string): string {
  const organ = OF_ORGAN[key as keyof SeasonLook];
  return organ ? `organ.${organ}` : `foliage.${OF_FOLIAGE[key as keyof SeasonLook] ?? key}`;
}

/** `look` with what a season says of it in place of its own; the same object where that is nothing. */
function dressed<Look extends object>(look: Look, season: SeasonLook, places: Partial<Record<string, string>>): Look {
  const said = Object.entries(season).filter(([key, value]) => value !== undefined && places[key] !== undefined);
  return said.length === 0
    ? look
    : { ...look, ...Object.fromEntries(said.map(([key, value]) => [places[key], value])) };
}

/**
 * The species as it looks in a season: foliage and organs replaced by what the season says of them, everything else shared, so that
 * the same tree stands in it. Summer is the species itself.
 */
export function inSeason(species: Species, season: Season): Species {
  if (season === 'summer') return species;
  const look = species[season];
  if (Object.keys(look).length === 0) return species;
  return {
    ...species,
    foliage: dressed(species.foliage, look, OF_FOLIAGE),
    organ: dressed(species.organ, look, OF_ORGAN),
  };
}

/** The seasons in which a species looks otherwise than in summer. */
export const ownSeasons = (species: Species): Season[] =>
  SEASONS.filter((season) => season !== 'summer' && Object.keys(species[season]).length > 0);
