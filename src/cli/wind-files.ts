import { existsSync, readdirSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';
import { faultText } from '../core/file/fault.ts';
import { nearest } from '../core/file/nearest.ts';
import type { Wind } from '../core/wind/wind.ts';
import { parseWindWithRecord } from '../core/wind/wind-with-record.ts';
import { Failure } from './failure.ts';
import { shippedFolder } from './shipped-folder.ts';
import { readText } from './species-files.ts';

/** The wind of a bake and of an export where nobody names another. */
export const DEFAULT_WIND = 'breeze';

/** Names of the shipped winds. */
export const shippedWinds = (): string[] =>
  readdirSync(shippedFolder('winds'))
    .filter((file) => file.endsWith('.json') && file !== 'index.json' && !file.endsWith('.schema.json'))
    .map((file) => file.slice(0, -'.json'.length))
    .sort();

/** The wind of a file, or of a shipped name, and a short name for it. */
export function findWind(nameOrFile: string): { id: string; wind: Wind } {
  const names = shippedWinds();
  const shipped = names.includes(nameOrFile.toLowerCase()) && !existsSync(nameOrFile);
  if (!shipped && !existsSync(nameOrFile) && !/[./\\]/.test(nameOrFile)) {
    const near = nearest(nameOrFile, names);
    throw new Failure(
      `There is no shipped wind and no file "${nameOrFile}".${near ? ` Did you mean ${near}?` : ''} Shipped: ${names.join(', ')}.`,
    );
  }
  const file = shipped ? join(shippedFolder('winds'), `${nameOrFile.toLowerCase()}.json`) : nameOrFile;
  const { wind, faults } = parseWindWithRecord(readText(file), (record) => readText(join(dirname(file), record)));
  if (faults) throw new Failure(faults.map((fault) => `${file}: ${faultText(fault)}`).join('\n'));
  return { id: basename(file, extname(file)), wind };
}
