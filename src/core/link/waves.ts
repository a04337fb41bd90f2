import type { Wave, Wind } from '../wind/wind.ts';
import { LINK_NUMBERS, roundTo, WAVE_NUMBERS, type WaveNumber, wrap } from './numbers.ts';

/** The value of a wave's number as people read it: degrees for the direction; directions and phases within one turn. */
export function shownNumber(wave: Wave, number: WaveNumber): number {
  const value = number.key === 'direction' ? (wave.direction * 180) / Math.PI : wave[number.key];
  return number.wraps ? wrap(number, value) : roundTo(number, value);
}

/** The wave with one number set from what people read, rounded as a link keeps it. */
export function withNumber(wave: Wave, number: WaveNumber, shown: number): Wave {
  const value = number.wraps ? wrap(number, shown) : roundTo(number, shown);
  return { ...wave, [number.key]: number.key === 'direction' ? (value * Math.PI) / 180 : value };
}

/** The wave with the digits that a link keeps. */
export function roundWave(wave: Wave): Wave {
  return WAVE_NUMBERS.reduce((w, number) => withNumber(w, number, shownNumber(wave, number)), wave);
}

/** The wind with the digits that a link keeps. */
export function roundWind(wind: Wind): Wind {
  return {
    ...wind,
    strength: roundTo(LINK_NUMBERS.strength, wind.strength),
    forceExponent: roundTo(LINK_NUMBERS.p, wind.forceExponent),
    lengthExponent: roundTo(LINK_NUMBERS.m, wind.lengthExponent),
    waves: wind.waves.map(roundWave),
  };
}
