import { faultText } from '../../src/core/file/fault.ts';
import { loadWind } from '../../src/core/wind/load-wind.ts';
import type { Wind } from '../../src/core/wind/wind.ts';

const text = async (file: string): Promise<string> => (await fetch(`/winds/${file}`)).text();

/** A wind that ships, by its id, as a page loads it. */
export async function shippedWind(id: string): Promise<Wind> {
  const { wind, faults } = await loadWind(await text(`${id}.json`), text);
  if (wind) return wind;
  throw new Error(`${id}: ${faults.map(faultText).join(' ')}`);
}
