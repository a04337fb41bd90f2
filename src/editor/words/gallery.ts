import type { Season } from '../../core/species/season.ts';
import type { SpeciesKind } from '../../core/species/species.ts';

const kinds: Readonly<Record<SpeciesKind, string>> = {
  broadleaf: 'Broadleaf',
  conifer: 'Conifers',
  palm: 'Palms',
  shrub: 'Shrubs',
  grass: 'Grasses',
  fern: 'Ferns',
  succulent: 'Succulents',
  bare: 'Bare',
};

const seasons: Readonly<Record<Season, string>> = {
  spring: 'Spring',
  summer: 'Summer',
  autumn: 'Autumn',
  winter: 'Winter',
};

/** Metres, as they are read. */
export const numberText = (value: number): string =>
  value < 10 ? String(Number(value.toFixed(1))) : String(Math.round(value));

/** The gallery of all species; the page of one has words of its own, which come with it. */
export const galleryWords = {
  intro: 'Each grows from one page of numbers and moves in real wind. Point at one to see it move.',
  introTouch: 'Each grows from one page of numbers and moves in real wind.',
  introStill: 'Each grows from one page of numbers. Choose one to open its page.',
  forest: 'A forest of them.',
  lessons: 'How they grow and move.',
  search: 'Name or Latin name',
  searchLabel: 'Find a species by its name or Latin name',
  kind: 'Kind',
  everyKind: 'All',
  kinds,
  season: 'Season',
  seasons,
  list: 'Species',
  count: (shown: number, all: number): string =>
    shown === all ? (all === 1 ? '1 species' : `${all} species`) : `${shown} of ${all} species`,
  none: 'No species is called so, or none of this kind.',
  noneHint: 'Try one word of its name, such as “pine” or “acer”.',
  showAll: 'Show all species',
  empty: 'The list of species could not be loaded. You can open a species file of your own in the editor.',
  /** Metres, where there is little room. */
  heightShort: ([low, high]: readonly [number, number]): string =>
    `${low === high ? '' : `${numberText(low)}–`}${numberText(high)}\u2009m`,
  now: 'now',
  failed: (reason: string): string => `Its file could not be loaded: ${reason}`,
} as const;
