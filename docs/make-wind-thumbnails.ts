// npx tsx docs/make-wind-thumbnails.ts: draws the thumbnails of public/winds, each from its wind's own field.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { faultText } from '../src/core/file/fault.ts';
import { parseIndex } from '../src/core/file/shipped-index.ts';
import { parseWindWithRecord } from '../src/core/wind/wind-with-record.ts';
import { windThumbnail } from './wind-thumbnail.ts';

const folder = join(import.meta.dirname, '../public/winds');
const read = (file: string): string => readFileSync(join(folder, file), 'utf8');

for (const { file, thumbnail } of parseIndex(JSON.parse(read('index.json'))).entries ?? []) {
  const { wind, faults } = parseWindWithRecord(read(file), read);
  if (faults) throw new Error(faults.map((fault) => `${file}: ${faultText(fault)}`).join('\n'));
  if (thumbnail) writeFileSync(join(folder, thumbnail), windThumbnail(wind));
}
