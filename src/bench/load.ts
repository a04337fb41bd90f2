import { faultText } from '../core/file/fault.ts';
import { parseSpecies } from '../core/species/parse.ts';
import type { Species } from '../core/species/species.ts';
import { loadWind } from '../core/wind/load-wind.ts';
import type { Wind } from '../core/wind/wind.ts';

async function text(path: string): Promise<string> {
  const answer = await fetch(new URL(path, document.baseURI));
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return answer.text();
}

/** A species that ships. Throws Error where it cannot be read. */
export async function shippedSpecies(id: string): Promise<Species> {
  const { species, faults } = parseSpecies(await text(`species/${id}.json`));
  if (species) return species;
  throw new Error(`${id}: ${faults.map(faultText).join(' ')}`);
}

/** A wind that ships. Throws Error where it cannot be read. */
export async function shippedWind(id: string): Promise<Wind> {
  const { wind, faults } = await loadWind(await text(`winds/${id}.json`), (csv) => text(`winds/${csv}`));
  if (wind) return wind;
  throw new Error(`${id}: ${faults.map(faultText).join(' ')}`);
}
