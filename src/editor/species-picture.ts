import type { Season } from '../core/species/season.ts';
import { publicUrl } from './public-file.ts';
import type { SpeciesEntry } from './session.ts';

const url = (path: string): string => publicUrl(`species/${path}`).href;

/** Addresses of a picture of a species, as `src` and `srcset` take them; null: it has none. */
export interface Picture {
  readonly src: string;
  readonly srcset: string | null;
}

/** Whether a species looks otherwise in a season than in summer. */
export const differs = ({ seasons = [] }: SpeciesEntry, season: Season): boolean => seasons.includes(season);

/** The picture of a species in a season: that of summer where the season changes nothing. */
export function pictureOf(entry: SpeciesEntry, season: Season): Picture | null {
  const { id, portrait, thumbnail } = entry;
  if (portrait && differs(entry, season)) return { src: url(`portraits/${id}-${season}.webp`), srcset: null };
  if (!portrait) return null;
  return { src: url(portrait), srcset: thumbnail ? `${url(thumbnail)} 160w, ${url(portrait)} 480w` : null };
}

/** The small picture of a species; null: it has none. */
export const thumbnailUrl = ({ thumbnail }: SpeciesEntry): string | null => (thumbnail ? url(thumbnail) : null);
