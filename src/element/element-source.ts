import type { Species } from '../core/species/species.ts';
import { STILL, type Wind } from '../core/wind/wind.ts';
import { isShippedId, type ShippedSource } from './shipped-source.ts';

/** What an element says of where its tree comes from. */
export interface TreeSource {
  readonly species: string;
  readonly src: string;
  readonly speciesData: Species | null;
}

/** What it says of where its wind comes from. */
export interface WindSourceWish {
  readonly wind: string;
  readonly windData: Wind | null;
}

/** The species that an element asks for; null where it asks for none. Rejects as `loadSpecies` and the source do. */
export async function speciesOf(
  { speciesData, src, species }: TreeSource,
  shipped: ShippedSource,
  signal: AbortSignal,
): Promise<Species | null> {
  if (speciesData) return (await import('./checked-data.ts')).checkedSpecies(speciesData);
  if (!src && isShippedId(species)) return shipped.speciesOf(species, signal);
  const address = src || species;
  if (!address) return null;
  const { loadSpecies } = await import('../view/load.ts');
  return loadSpecies(address, { signal });
}

/** The wind that an element asks for, before its attributes change it. */
export async function windOf(
  { windData, wind }: WindSourceWish,
  shipped: ShippedSource,
  signal: AbortSignal,
): Promise<Wind> {
  if (windData) return (await import('./checked-data.ts')).checkedWind(windData);
  if (!wind) return STILL;
  if (isShippedId(wind)) return shipped.windOf(wind, signal);
  const { loadWind } = await import('../view/load.ts');
  return loadWind(wind, { signal });
}
