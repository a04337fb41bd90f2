import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import { faultText } from '../core/file/fault.ts';
import { nearest } from '../core/file/nearest.ts';
import { parseArbaro } from '../core/io/arbaro.ts';
import { parseEzTree } from '../core/io/ez-tree.ts';
import { type Imported, isArbaro, isEzTree } from '../core/io/imported.ts';
import { parseSpecies } from '../core/species/parse.ts';
import type { Species } from '../core/species/species.ts';
import { Failure } from './failure.ts';
import { shippedFolder } from './shipped-folder.ts';

/** Names of the shipped species, as `windgrove stats` takes them. */
export const shippedNames = (): string[] =>
  readdirSync(shippedFolder('species'))
    .filter((file) => file.endsWith('.json') && file !== 'index.json' && !file.endsWith('.schema.json'))
    .map((file) => file.slice(0, -'.json'.length))
    .sort();

/** The text of a file, or a Failure that says why not. */
export function readText(file: string): string {
  try {
    if (statSync(file).isDirectory()) throw new Failure(`${file}: is a folder, not a file.`);
    return readFileSync(file, 'utf8');
  } catch (error) {
    if (error instanceof Failure) throw error;
    const code = (error as NodeJS.ErrnoException).code;
    throw new Failure(`${file}: ${code === 'ENOENT' ? 'there is no such file' : `cannot be read (${code})`}.`);
  }
}

/** Another program's tree that a text may be, and its reader; undefined where it looks like none of them. */
export function importerOf(text: string): { program: string; parse: (text: string) => Imported } | undefined {
  if (isArbaro(text)) return { program: 'Arbaro', parse: parseArbaro };
  return isEzTree(text) ? { program: 'ez-tree', parse: parseEzTree } : undefined;
}

function ownSpecies(text: string): Imported {
  const { species, faults } = parseSpecies(text);
  return faults ? { faults } : { species, notes: [] };
}

/** A species and a short name for it and its files. */
export interface FoundSpecies {
  readonly id: string;
  readonly species: Species;
}

/** The species of a file, or of a shipped name; `note` is told what an import could not carry over. */
export function findSpecies(nameOrFile: string, note: (line: string) => void = () => {}): FoundSpecies {
  const names = shippedNames();
  const shipped = names.includes(nameOrFile.toLowerCase()) && !existsSync(nameOrFile);
  if (!shipped && !existsSync(nameOrFile) && !/[./\\]/.test(nameOrFile)) {
    const alike = names.filter((name) => name.includes(nameOrFile.toLowerCase()));
    const near = alike.length === 1 ? alike[0] : nearest(nameOrFile, names);
    throw new Failure(
      `There is no shipped species and no file "${nameOrFile}".${near ? ` Did you mean ${near}?` : ''} Shipped: ${names.join(', ')}.`,
    );
  }
  const file = shipped ? join(shippedFolder('species'), `${nameOrFile.toLowerCase()}.json`) : nameOrFile;
  const text = readText(file);
  const importer = importerOf(text);
  const read = importer ? importer.parse(text) : ownSpecies(text);
  if (read.faults) throw new Failure(read.faults.map((fault) => `${file}: ${faultText(fault)}`).join('\n'));
  for (const line of read.notes) note(`${file}: ${line}`);
  return { id: basename(file, extname(file)), species: read.species };
}
