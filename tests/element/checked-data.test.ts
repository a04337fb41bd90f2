import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { blend } from '../../src/core/species/blend.ts';
import { parseSpecies } from '../../src/core/species/parse.ts';
import type { Species } from '../../src/core/species/species.ts';
import { parseWind } from '../../src/core/wind/parse-wind.ts';
import { STILL, type Wind } from '../../src/core/wind/wind.ts';
import { checkedSpecies, checkedWind } from '../../src/element/checked-data.ts';

const filesOf = (folder: string): string[] =>
  readdirSync(join('public', folder))
    .filter((name) => name.endsWith('.json') && !/^index|schema/.test(name))
    .map((name) => readFileSync(join('public', folder, name), 'utf8'));

const species = filesOf('species').map((text) => parseSpecies(text).species as Species);
const winds = filesOf('winds').flatMap((text) => parseWind(text).wind ?? []);

it('takes every species that ships and blends of two as they are, and the same object once', () => {
  expect(species.length).toBeGreaterThan(20);
  for (const [i, one] of species.entries()) {
    expect(checkedSpecies(one)).toEqual(one);
    const between = blend(one, species[(i + 1) % species.length] as Species, 0.37);
    expect(checkedSpecies(between)).toEqual(between);
    expect(checkedSpecies(between)).toBe(checkedSpecies(between));
  }
});

it('takes every wind that ships', () => {
  for (const wind of [STILL, ...winds]) expect(checkedWind(wind)).toBe(wind);
});

it('says what is wrong with half a species or half a wind, where in it, and what is allowed', () => {
  const half = (data: unknown) => () => checkedSpecies(data as Species);
  const still = (data: unknown) => () => checkedWind(data as Wind);
  expect(half({ name: 'Half', levels: [1] })).toThrow(/^speciesData: format: .*allowed/);
  const [first] = species as [Species];
  expect(half({ ...first, levels: [1] })).toThrow(/^speciesData: levels\[0\]: found .*allowed/);
  expect(still({ name: 'Half', waves: [1], gusts: [] })).toThrow(/^windData: The wind: found parts missing; allowed/);
  expect(still({ ...STILL, waves: [1] })).toThrow(/^windData: waves\[0\]\.\w+: found .*allowed/);
});
