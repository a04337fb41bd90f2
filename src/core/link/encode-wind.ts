import { STILL, type Wind } from '../wind/wind.ts';
import { OWN_WIND } from './document.ts';
import { WAVE_NUMBERS } from './numbers.ts';
import { shownGustNumber, shownNumber } from './waves.ts';
import { GUST_NUMBERS } from './wind-numbers.ts';

/** Waves of a link that does not say how many it has: so many had all of them once. */
export const USUAL_WAVES = 4;

const same = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);

/**
 * Puts a rounded wind as pairs of key and value.
 *
 * Strength, waves, exponents and model always stand there, so that a link keeps its picture when the winds that ship are tuned;
 * what is as in `STILL` (no gusts, no profile, ...) is left out. Of a record the link holds the name alone.
 */
export function encodeWind(preset: string, wind: Wind, put: (key: string, value: string | number) => void): void {
  put('wind', preset);
  if (preset === OWN_WIND) {
    put('name', wind.name);
    if (wind.description) put('says', wind.description);
  }
  put('strength', wind.strength);
  if (wind.waves.length !== USUAL_WAVES) put('waves', wind.waves.length);
  wind.waves.forEach((wave, i) => {
    const flags = [...(wave.on ? [] : ['off']), ...(wave.solo ? ['solo'] : [])];
    put(`w${i + 1}`, [...WAVE_NUMBERS.map((n) => shownNumber(wave, n)), ...flags].join());
  });
  wind.gusts.forEach((gust, i) => {
    // The last one, its repeat, is left out where it comes once.
    const numbers = GUST_NUMBERS.map((n) => shownGustNumber(gust, n));
    put(`g${i + 1}`, (gust.repeat > 0 ? numbers : numbers.slice(0, -1)).join());
  });
  const { profile, spring, sway } = wind;
  if (!same(profile, STILL.profile)) {
    put('profile', [profile.kind, profile.height, profile.roughness, profile.exponent].join());
  }
  if (wind.zeroMean) put('zero', 1);
  if (wind.record) put('rec', wind.record.name);
  if (wind.stiffness !== STILL.stiffness) put('stiff', wind.stiffness);
  put('model', wind.model);
  const plain = [spring.frequency, spring.damping, spring.inertia];
  const still = STILL.spring;
  if (!same(plain, [still.frequency, still.damping, still.inertia])) put('spring', plain.join());
  if (spring.levels.length > 0) {
    put('levelhz', spring.levels.map((l) => l.frequency ?? 'grown').join());
    put('leveldamp', spring.levels.map((l) => l.damping ?? 'grown').join());
  }
  if (!same(sway, STILL.sway)) put('sway', [sway.reading, sway.speed, sway.gust, sway.rate].join());
  put('p', wind.forceExponent);
  put('m', wind.lengthExponent);
  if (wind.pose !== 'exact') put('pose', wind.pose);
  if (wind.paper) put('paper', 1);
}
