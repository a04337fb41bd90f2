import { sameValue, valueAt } from '../../../core/species/edits.ts';
import { inSeason, type Season, summerPath } from '../../../core/species/season.ts';
import type { Species } from '../../../core/species/species.ts';

/** Why a parameter of the look does nothing. */
export type WhyLook =
  | 'noMoss'
  | 'noLichen'
  | 'ownMargin'
  | 'noSecond'
  | 'noneTurned'
  | 'noCover'
  | 'noOrgan'
  | 'asSummer';

const CHANGING: readonly Season[] = ['spring', 'autumn', 'winter'];

/** The species as it looks in summer and in each other season. */
const throughYear = (species: Species): Species[] => [species, ...CHANGING.map((season) => inSeason(species, season))];

export function ofBark({ bark }: Species, key: string): WhyLook | undefined {
  if (key === 'mossColour' && bark.moss === 0) return 'noMoss';
  return key === 'lichenColour' && bark.lichen === 0 ? 'noLichen' : undefined;
}

/** Of the foliage that a species has leaves for. */
export function ofFoliage(species: Species, key: string): WhyLook | undefined {
  if (key === 'cover') return undefined;
  const year = throughYear(species);
  if (year.every(({ foliage }) => foliage.cover === 0)) return 'noCover';
  if (key === 'outline' && species.foliage.margin) return 'ownMargin';
  if (key === 'second' && year.every(({ foliage }) => foliage.secondShare === 0)) return 'noneTurned';
  return key === 'secondShare' && year.every(({ foliage }) => foliage.second === undefined) ? 'noSecond' : undefined;
}

export function ofOrgan(species: Species, key: string): WhyLook | undefined {
  return key !== 'kind' && throughYear(species).every(({ organ }) => organ.kind === 'none') ? 'noOrgan' : undefined;
}

/** Of what a season changes. */
export function ofSeason(species: Species, season: Season, key: string): WhyLook | undefined {
  const { foliage, organ } = inSeason(species, season);
  const path = `${season}.${key}`;
  const value = valueAt(species, path);
  if (key !== 'organ' && key.startsWith('organ') && organ.kind === 'none') return 'noOrgan';
  if (key !== 'cover' && !key.startsWith('organ') && foliage.cover === 0) return 'noCover';
  if (key === 'second' && foliage.secondShare === 0) return 'noneTurned';
  if (key === 'secondShare' && foliage.second === undefined) return 'noSecond';
  return value !== null && sameValue(value, valueAt(species, summerPath(key))) ? 'asSummer' : undefined;
}
