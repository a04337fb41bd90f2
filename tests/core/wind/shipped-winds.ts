import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { faultText } from '../../../src/core/file/fault.ts';
import type { Wind } from '../../../src/core/wind/wind.ts';
import { parseWindWithRecord } from '../../../src/core/wind/wind-with-record.ts';

/** Where the winds lie that ship. */
export const windsFolder = join(import.meta.dirname, '../../../public/winds');

/** The text of a file among them. */
export const windsText = (file: string): string => readFileSync(join(windsFolder, file), 'utf8');

/** Ids of the winds that ship. */
export const windNames: readonly string[] = readdirSync(windsFolder)
  .filter((file) => file.endsWith('.json') && file !== 'index.json' && !file.endsWith('.schema.json'))
  .map((file) => file.slice(0, -'.json'.length));

/** A wind that ships, as the editor loads it. */
export function shippedWind(id: string): Wind {
  const { wind, faults } = parseWindWithRecord(windsText(`${id}.json`), windsText);
  if (wind) return wind;
  throw new Error(`${id}.json: ${faults.map(faultText).join('\n')}`);
}

/** The same without state: any time comes at once. */
export const directWind = (id: string): Wind => ({ ...shippedWind(id), model: 'direct' });
