import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import type { Plugin } from 'vite';
import { faultText } from '../src/core/file/fault.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import { parseWindWithRecord } from '../src/core/wind/wind-with-record.ts';

/**
 * Reads the species and winds that ship while the library is built: its modules hold them as `parseSpecies` and `loadWind` would give them, so
 * that a page that shows one needs neither, nor the tables that they read by.
 */
export function shippedParsed(): Plugin {
  return {
    name: 'windgrove:shipped-parsed',
    enforce: 'pre',
    transform: {
      filter: { id: /\/public\/(species|winds)\/[\w-]+\.json$/ },
      handler(code, id) {
        const read = id.includes('/public/species/')
          ? parseSpecies(code)
          : parseWindWithRecord(code, (record) => readFileSync(join(dirname(id), record), 'utf8'));
        if (read.faults) throw new Error(`${id}: ${read.faults.map(faultText).join(' ')}`);
        return { code: JSON.stringify('species' in read ? read.species : read.wind), map: null };
      },
    },
  };
}
