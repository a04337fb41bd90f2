import { WIND_TEXTS } from '../wind/parse-wind.ts';
import { MOST_GUSTS, MOST_WAVES, SPRING_LEVELS, type SpringLevel, type Wind } from '../wind/wind.ts';
import { LINK_NUMBERS } from './numbers.ts';
import { roundTo } from './rule.ts';
import { roundGust, roundWave } from './waves.ts';
import { WIND_NUMBERS } from './wind-numbers.ts';

const roundLevel = ({ frequency, damping }: SpringLevel): SpringLevel => ({
  frequency: frequency === null ? null : roundTo(WIND_NUMBERS.hertz, frequency),
  damping: damping === null ? null : roundTo(WIND_NUMBERS.damping, damping),
});

/** Whole letters, so that an address can hold them: half of an emoji has no code. */
const cut = (text: string, letters: number): string =>
  [...text.replace(/\p{Surrogate}/gu, '\ufffd')].slice(0, letters).join('');

/** The wind with the digits that a link keeps. */
export function roundWind(wind: Wind): Wind {
  const { profile, spring, sway } = wind;
  return {
    ...wind,
    name: cut(wind.name, WIND_TEXTS.name.longest),
    description: cut(wind.description, WIND_TEXTS.description.longest),
    strength: roundTo(LINK_NUMBERS.strength, wind.strength),
    waves: wind.waves.slice(0, MOST_WAVES).map(roundWave),
    gusts: wind.gusts.slice(0, MOST_GUSTS).map(roundGust),
    profile: {
      ...profile,
      height: roundTo(WIND_NUMBERS.height, profile.height),
      roughness: roundTo(WIND_NUMBERS.roughness, profile.roughness),
      exponent: roundTo(WIND_NUMBERS.exponent, profile.exponent),
    },
    stiffness: roundTo(WIND_NUMBERS.stiffness, wind.stiffness),
    spring: {
      frequency: roundTo(WIND_NUMBERS.frequency, spring.frequency),
      damping: roundTo(WIND_NUMBERS.damping, spring.damping),
      inertia: roundTo(WIND_NUMBERS.inertia, spring.inertia),
      levels: spring.levels.slice(0, SPRING_LEVELS).map(roundLevel),
    },
    sway: {
      ...sway,
      speed: roundTo(WIND_NUMBERS.swaySpeed, sway.speed),
      gust: roundTo(WIND_NUMBERS.swayGust, sway.gust),
      rate: roundTo(WIND_NUMBERS.rate, sway.rate),
    },
    forceExponent: roundTo(LINK_NUMBERS.p, wind.forceExponent),
    lengthExponent: roundTo(LINK_NUMBERS.m, wind.lengthExponent),
  };
}
