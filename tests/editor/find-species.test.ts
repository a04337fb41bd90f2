import { describe, expect, it } from 'vitest';
import { findSpecies, kindsOf } from '../../src/editor/gallery/find-species.ts';
import type { SpeciesEntry } from '../../src/editor/session.ts';

const entry = (id: string, name: string, latin: string, kind?: SpeciesEntry['kind']): SpeciesEntry => ({
  id,
  name,
  latin,
  file: `${id}.json`,
  ...(kind ? { kind } : {}),
});
const species = [
  entry('jack-pine', 'Jack Pine', 'Pinus banksiana', 'conifer'),
  entry('olive', 'Olive', 'Olea europaea', 'broadleaf'),
  entry('fig', 'Fig', 'Ficus carica'),
];

describe('the gallery finds', () => {
  it.each([
    ['', null, ['jack-pine', 'olive', 'fig']],
    ['pin', null, ['jack-pine']],
    ['OLEA', null, ['olive']],
    ['conif', null, ['jack-pine']],
    ['', 'broadleaf', ['olive']],
    ['pine', 'broadleaf', []],
  ] as const)('by "%s" of kind %s: %j', (query, kind, ids) => {
    expect(findSpecies(species, query, kind).map(({ id }) => id)).toEqual(ids);
  });

  it('the kinds that there are, in the order of all', () => {
    expect(kindsOf(species)).toEqual(['broadleaf', 'conifer']);
  });
});
