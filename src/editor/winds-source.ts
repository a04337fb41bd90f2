import { roundWind } from '../core/link/link.ts';
import { loadWind as withRecord } from '../core/wind/load-wind.ts';
import { STILL, type Wind } from '../core/wind/wind.ts';
import { FileError } from './file-error.ts';
import { FIRST_WIND } from './first-document.ts';
import { fetchText, publicUrl } from './public-file.ts';
import type { ShippedWind } from './session.ts';
import { messageWords } from './words/messages.ts';

/** An entry of `winds/index.json`. */
interface WindEntry {
  readonly id: string;
  readonly name: string;
  readonly file: string;
  readonly description: string;
  readonly thumbnail: string;
}

async function loadWind({ id, name, file, description, thumbnail }: WindEntry): Promise<ShippedWind> {
  const parsed = await withRecord(await fetchText(`winds/${file}`, name), (csv) => fetchText(`winds/${csv}`, name));
  if (!parsed.wind) throw FileError.of(messageWords.cannotBlow(name), parsed.faults);
  return {
    id,
    name,
    description,
    thumbnail: publicUrl(`winds/${thumbnail}`).href,
    wind: roundWind(parsed.wind),
  };
}

/** The winds that ship, and what kept others from being among them; there is always the first one. */
export async function loadWinds(): Promise<{ winds: readonly ShippedWind[]; broken: readonly unknown[] }> {
  const broken: unknown[] = [];
  const found = await fetchText('winds/index.json', messageWords.lists.winds)
    .then((text) => Promise.allSettled((JSON.parse(text) as WindEntry[]).map(loadWind)))
    .catch((error: unknown) => {
      broken.push(error);
      return [];
    });
  const winds = found.flatMap((result) => {
    if (result.status === 'fulfilled') return [result.value];
    broken.push(result.reason);
    return [];
  });
  return { winds, broken };
}

/** The wind of a first visit. */
export const firstWind = (winds: readonly ShippedWind[]): Wind => winds.find((w) => w.id === FIRST_WIND)?.wind ?? STILL;
