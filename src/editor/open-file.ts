import type { Actions } from './actions.ts';
import { textOf } from './public-file.ts';
import { readOwnFile } from './species-source.ts';

/** Opens what the reader gives: a species, a wind or a measured wind, whichever the file says that it is. */
export async function openFile(file: File, actions: Actions): Promise<void> {
  const text = await textOf(file, actions.longestWind);
  if (isWindText(text)) actions.openWind(text, file.name);
  else if (/\.csv$/i.test(file.name)) actions.openRecord(text, file.name);
  else actions.openSpecies(await readOwnFile(file));
}

/** A file of a wind says so in its first lines, whatever else is wrong with it. */
export const isWindText = (text: string): boolean => /"format"\s*:\s*"windgrove-wind"/.test(text);
