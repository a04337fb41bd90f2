import { nearest } from '../core/file/nearest.ts';
import { type LinkFault, LinkReader } from '../core/link/reader.ts';
import type { NumberRule } from '../core/link/rule.ts';
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

/** What the numbers of an address may be. */
const RULES = {
  range: { label: 'range', unit: 'm', min: NEAREST, max: FARTHEST, decimals: 1 },
  quality: { label: 'quality', unit: '', min: 0.1, max: 1, decimals: 2 },
  seed: { label: 'seed', unit: '', min: 0, max: 2 ** 31, decimals: 0 },
} as const satisfies Readonly<Record<string, NumberRule>>;

/** Reads a query: what is missing is as at the start, and so is what is wrong, each with a fault. */
export function readState(query: string): { state: RangeState; faults: readonly LinkFault[] } {
  const reader = new LinkReader(new Map(new URLSearchParams(query)));
  const state: RangeState = {
    range: reader.number('range', RULES.range, START.range),
    way: reader.choice('draw', START.way, WAYS),
    near: reader.flag('near', START.near),
    quality: reader.number('quality', RULES.quality, START.quality),
    season: reader.choice('season', START.season, SEASONS),
    wind: reader.flag('wind', START.wind),
    dark: reader.has('dark') ? reader.flag('dark', false) : START.dark,
    seed: reader.number('seed', RULES.seed, START.seed),
  };
  // Keys that are nearly ours are slips of the pen; others are somebody else's, such as those that mail programs add.
  for (const [key, value] of reader.values) {
    const near = nearest(key.slice(0, 40), [...reader.known]);
    if (near) reader.fault(key, value, `${near}, if that was meant`);
  }
  return { state, faults: reader.faults };
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
