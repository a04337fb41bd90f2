import { readFileSync } from 'node:fs';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import type { Species } from '../../../src/core/species/species.ts';

/** The species that ship, by file name. */
export const SHIPPED = ['quaking-aspen', 'black-tupelo', 'weeping-willow', 'california-black-oak'] as const;

export function shippedSpecies(name: (typeof SHIPPED)[number]): Species {
  const { species, faults } = parseSpecies(readFileSync(`public/species/${name}.json`, 'utf8'));
  if (!species) throw new Error(JSON.stringify(faults));
  return species;
}
