import { SEASONS, type Season } from '../core/species/season.ts';

/** How the tree is drawn: by the paper's rules, by what shows on the screen, or all of it. */
export const WAYS = ['paper', 'screen', 'full'] as const;
export type Way = (typeof WAYS)[number];

/** What the address says. */
export interface RangeState {
  /** Metres. */
  readonly range: number;
  readonly way: Way;
  readonly near: boolean;
  readonly quality: number;
  readonly season: Season;
  readonly wind: boolean;
  /** null: as the system is. */
  readonly dark: boolean | null;
  readonly seed: number;
}

export const NEAREST = 5;
export const FARTHEST = 2000;

const START: RangeState = {
  range: 60,
  way: 'paper',
  near: true,
  quality: 1,
  season: 'summer',
  wind: true,
  dark: null,
  seed: 1,
};

const oneOf = <T extends string>(list: readonly T[], text: string | null, otherwise: T): T =>
  list.find((each) => each === text) ?? otherwise;

function within(text: string | null, low: number, high: number, otherwise: number): number {
  const n = Number.parseFloat(text ?? '');
  return Number.isFinite(n) ? Math.min(high, Math.max(low, n)) : otherwise;
}

const flag = <T>(text: string | null, otherwise: T): boolean | T => (text === null ? otherwise : text === '1');

/** Reads a query; what is missing or makes no sense is as at the start. */
export function readState(query: string): RangeState {
  const q = new URLSearchParams(query);
  return {
    range: within(q.get('range'), NEAREST, FARTHEST, START.range),
    way: oneOf(WAYS, q.get('draw'), START.way),
    near: flag(q.get('near'), START.near),
    quality: within(q.get('quality'), 0.1, 1, START.quality),
    season: oneOf(SEASONS, q.get('season'), START.season),
    wind: flag(q.get('wind'), START.wind),
    dark: flag(q.get('dark'), START.dark),
    seed: Math.round(within(q.get('seed'), 0, 2 ** 31, START.seed)),
  };
}

/** The query of a state: what is as at the start is left out. */
export function writeState(state: RangeState): string {
  const q = new URLSearchParams();
  const put = (name: string, value: string | number | boolean | null, start: unknown): void => {
    if (value !== start && value !== null)
      q.set(name, typeof value === 'boolean' ? (value ? '1' : '0') : String(value));
  };
  put('range', Math.round(state.range), START.range);
  put('draw', state.way, START.way);
  put('near', state.near, START.near);
  put('quality', Number(state.quality.toFixed(2)), START.quality);
  put('season', state.season, START.season);
  put('wind', state.wind, START.wind);
  put('dark', state.dark, START.dark);
  put('seed', state.seed, START.seed);
  const text = q.toString();
  return text ? `?${text}` : '';
}

/** Place on a slider of 0..1 for a range, and back: each tenth is the same factor. */
export const toSlider = (range: number): number => Math.log(range / NEAREST) / Math.log(FARTHEST / NEAREST);
export const fromSlider = (x: number): number => {
  const range = NEAREST * (FARTHEST / NEAREST) ** x;
  const step = range < 30 ? 1 : range < 200 ? 5 : range < 500 ? 10 : 50;
  return Math.round(range / step) * step;
};
