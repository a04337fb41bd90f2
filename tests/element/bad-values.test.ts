import { expect, it } from 'vitest';
import { ATTRIBUTES } from '../../src/element/attributes.ts';
import { putBackBad } from '../../src/element/bad-values.ts';

/** An element with the usual values and what is given, of which all has just changed from `before`. */
function check(given: Record<string, unknown>, before: Record<string, unknown> = {}) {
  const usual = Object.values(ATTRIBUTES).map(({ property, usual }) => [property, usual] as const);
  const element: Record<string, unknown> = { ...Object.fromEntries(usual), ...given };
  const told: string[] = [];
  putBackBad(element, new Map(Object.keys(given).map((key) => [key, before[key]])), (type, message) =>
    told.push(`${type}: ${message}`),
  );
  return { element, told };
}

it('puts back what was there, or what is usual, and names attribute, value and what may be', () => {
  const { element, told } = check({ seed: 'twelve', windSpeed: -1, season: 'winter' }, { seed: 4 });
  expect(element).toMatchObject({ seed: 4, windSpeed: null, season: 'winter' });
  expect(told).toEqual([
    'attribute: seed="twelve" is not allowed: it may be a whole number from 0 to 4294967295.',
    'attribute: wind-speed="-1" is not allowed: it may be a speed from 0 to 60 m/s with its unit: "6m/s" or "20km/h".',
  ]);
});

it('takes as species and wind only what looks like them: half of one would break what is shown', () => {
  const wind = { name: 'Own', waves: [], gusts: [] };
  expect(check({ windData: wind, speciesData: { name: 'Own', levels: [] } }).told).toEqual([]);
  for (const bad of [{}, 'oak', 7, [], { name: 'Own' }, { levels: [], waves: [], gusts: [] }]) {
    const { element, told } = check({ windData: bad, speciesData: bad }, { windData: wind });
    expect(element).toMatchObject({ windData: wind, speciesData: null });
    expect(told).toEqual([
      'species: speciesData is not allowed: it may be a species as `loadSpecies` gives it, or null.',
      'wind: windData is not allowed: it may be a wind as `loadWind` gives it, or null.',
    ]);
  }
});
