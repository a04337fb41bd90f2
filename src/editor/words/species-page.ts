import type { SpeciesKind } from '../../core/species/species.ts';
import { numberText as number } from './gallery.ts';

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

const range = (low: string, high: string): string => (low === high ? low : `${low} to ${high}`);
const percent = ([low, high]: readonly [number, number]): string =>
  range(String(Math.round(100 * low)), String(Math.round(100 * high)));
const metres = ([low, high]: readonly [number, number]): string => `${range(number(low), number(high))}\u2009m`;

/** The page of a species in the gallery. */
export const speciesPageWords = {
  back: 'All species',
  edit: 'Edit this tree',
  embed: 'Copy the embed code',
  download: 'Download the file',
  copied: 'The embed code is copied; paste it into the HTML of your page.',
  shown: 'The browser does not let this page copy; here is the embed code:',
  loading: 'Loading its page…',
  seasons: 'Through the year',
  inSeason: (name: string, season: string): string => `${name} in ${season.toLowerCase()}`,
  facts: 'Grown trees',
  portrait: (name: string): string => `${name}, the whole tree`,
  kind: 'Kind',
  oneOf,
  heightOf: 'Height',
  height: metres,
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
} as const;
