import { gustRepeat } from '../wind/gust.ts';
import type { Gust, Wave } from '../wind/wind.ts';
import { WAVE_NUMBERS, type WaveNumber } from './numbers.ts';
import { kept, type NumberRule } from './rule.ts';
import { GUST_NUMBERS, type GustNumber } from './wind-numbers.ts';

/** `value` of the document as people read it: degrees for directions; directions and phases within one turn. */
const shown = (number: NumberRule & { readonly key: string }, value: number): number =>
  kept(number, number.key === 'direction' ? (value * 180) / Math.PI : value);

/** The value of the document that people read as `value`, rounded as a link keeps it. */
const meant = (number: NumberRule & { readonly key: string }, value: number): number =>
  number.key === 'direction' ? (kept(number, value) * Math.PI) / 180 : kept(number, value);

/** The value of a wave's number as people read it. */
export const shownNumber = (wave: Wave, number: WaveNumber): number => shown(number, wave[number.key]);

/** The wave with one number set from what people read, rounded as a link keeps it. */
export const withNumber = (wave: Wave, number: WaveNumber, value: number): Wave => ({
  ...wave,
  [number.key]: meant(number, value),
});

/** The value of a gust's number as people read it. */
export const shownGustNumber = (gust: Gust, number: GustNumber): number => shown(number, gust[number.key]);

const REPEAT = GUST_NUMBERS.find((n) => n.key === 'repeat')!;

/** The gust with one number set from what people read, rounded as a link keeps it; it comes again when it is over, not before. */
export function withGustNumber(gust: Gust, number: GustNumber, value: number): Gust {
  const changed = { ...gust, [number.key]: meant(number, value) };
  return changed.repeat > 0 ? { ...changed, repeat: kept(REPEAT, gustRepeat(changed)) } : changed;
}

/** The wave with the digits that a link keeps. */
export const roundWave = (wave: Wave): Wave =>
  WAVE_NUMBERS.reduce((w, number) => withNumber(w, number, shownNumber(wave, number)), wave);

/** The gust with the digits that a link keeps. */
export const roundGust = (gust: Gust): Gust =>
  GUST_NUMBERS.reduce((g, number) => withGustNumber(g, number, shownGustNumber(gust, number)), gust);
