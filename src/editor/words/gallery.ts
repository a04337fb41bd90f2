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

const oneOf: Readonly<Record<SpeciesKind, string>> = {
  broadleaf: 'Broadleaf tree',
  conifer: 'Conifer',
  palm: 'Palm',
  shrub: 'Shrub',
  grass: 'Grass',
  fern: 'Fern',
  succulent: 'Succulent',
  bare: 'Bare tree',
};

const seasons: Readonly<Record<Season, string>> = {
  spring: 'Spring',
  summer: 'Summer',
  autumn: 'Autumn',
  winter: 'Winter',
};

const number = (value: number): string => (value < 10 ? String(Number(value.toFixed(1))) : String(Math.round(value)));
const range = (low: string, high: string): string => (low === high ? low : `${low} to ${high}`);
const percent = ([low, high]: readonly [number, number]): string =>
  range(String(Math.round(100 * low)), String(Math.round(100 * high)));
const metres = ([low, high]: readonly [number, number]): string => `${range(number(low), number(high))}\u2009m`;

/** The gallery of all species, and the page of one. */
export const galleryWords = {
  intro: 'Each grows from one page of numbers and moves in real wind. Point at one to see it move.',
  introTouch: 'Each grows from one page of numbers and moves in real wind.',
  introStill: 'Each grows from one page of numbers. Choose one to open its page.',
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
  height: metres,
  /** The same where there is little room. */
  heightShort: ([low, high]: readonly [number, number]): string =>
    `${low === high ? '' : `${number(low)}–`}${number(high)}\u2009m`,
  portrait: (name: string): string => `${name}, the whole tree`,
  now: 'now',
  page: {
    back: 'All species',
    edit: 'Edit this tree',
    embed: 'Copy the embed code',
    download: 'Download the file',
    copied: 'The embed code is copied; paste it into the HTML of your page.',
    shown: 'The browser does not let this page copy; here is the embed code:',
    failed: (reason: string): string => `Its file could not be loaded: ${reason}`,
    loading: 'Loading its page…',
    seasons: 'Through the year',
    inSeason: (name: string, season: string): string => `${name} in ${season.toLowerCase()}`,
    facts: 'Grown trees',
    kind: 'Kind',
    oneOf,
    heightOf: 'Height',
    spread: 'Width of the crown',
    clear: 'Bare trunk',
    range: 'Grows wild in',
    measured: 'Measures from',
    made: 'Numbers from',
    spreadOf: (part: readonly [number, number]): string => `${percent(part)}\u2009% of the height`,
    clearOf: (part: readonly [number, number]): string =>
      part[1] === 0 ? 'none' : `${percent(part)}\u2009% of the height`,
    parameters: 'All its numbers',
    parametersHint: 'The whole species is these numbers. In the editor every one of them is a control.',
    parameter: 'Parameter',
    value: 'Value',
    sameKind: 'Before and after',
    previous: 'Previous species',
    next: 'Next species',
  },
} as const;
