import { parseSpecies } from '../core/species/parse.ts';
import type { Species } from '../core/species/species.ts';
import { parseWind } from '../core/wind/parse-wind.ts';
import type { Wind } from '../core/wind/wind.ts';
import { windToFile } from '../core/wind/wind-file.ts';
import { LoadError } from '../view/load.ts';

/** Of each object that was given its species: an element that is put elsewhere need not grow it again. */
const species = new WeakMap<Species, Species>();

/**
 * A species that a page made, held against the rules of its file: half of one would break in the midst of growing. What a file may leave
 * out it may leave out, too. Throws LoadError, which says where and what is allowed.
 */
export function checkedSpecies(data: Species): Species {
  const known = species.get(data);
  if (known) return known;
  const parsed = parseSpecies(data);
  if (!parsed.species) throw new LoadError('speciesData', parsed.faults);
  species.set(data, parsed.species);
  return parsed.species;
}

/** A wind that a page made, held against the rules of its file: half of one would break in the midst of drawing. Throws LoadError. */
export function checkedWind(data: Wind): Wind {
  const { wind, faults } = parseWind(fileOf(data));
  if (!wind) throw new LoadError('windData', faults);
  return data;
}

function fileOf(data: Wind): object {
  try {
    return windToFile(data);
  } catch {
    throw new LoadError('windData', [
      { path: 'The wind', found: 'parts missing', allowed: 'a wind as loadWind gives it' },
    ]);
  }
}
