import type { ExportFile } from './export-options.ts';
import type { WriteFormat } from './export-tree.ts';

/** Text as the bytes of a file. */
export const textFile = (name: string, text: string, type: string): ExportFile => ({
  name,
  bytes: new TextEncoder().encode(text),
  type,
});

/** The species as its own file, which `windgrove validate` accepts and the editor opens. */
export const exportSpecies: WriteFormat = ({ species, name }) => [
  textFile(`${name}.json`, `${JSON.stringify(species, null, 2)}\n`, 'application/json'),
];
