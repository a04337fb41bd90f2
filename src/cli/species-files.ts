import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { faultText } from '../core/file/fault.ts';
import { nearest } from '../core/file/nearest.ts';
import { parseSpecies } from '../core/species/parse.ts';
import type { Species } from '../core/species/species.ts';
import { Failure } from './failure.ts';

/** The folder of the shipped species: beside the built command, or in the tree's public folder. */
function shippedFolder(): string {
  const beside = join(import.meta.dirname, 'species');
  if (existsSync(beside)) return beside;
  for (let folder = import.meta.dirname; folder !== dirname(folder); folder = dirname(folder)) {
    const candidate = join(folder, 'public', 'species');
    if (existsSync(candidate)) return candidate;
  }
  throw new Failure('The shipped species are missing from this installation.');
}

/** Names of the shipped species, as `windgrove stats` takes them. */
export const shippedNames = (): string[] =>
  readdirSync(shippedFolder())
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

/** The species of a file, or of a shipped name. */
export function findSpecies(nameOrFile: string): Species {
  const names = shippedNames();
  const shipped = names.includes(nameOrFile.toLowerCase()) && !existsSync(nameOrFile);
  if (!shipped && !existsSync(nameOrFile) && !/[./\\]/.test(nameOrFile)) {
    const alike = names.filter((name) => name.includes(nameOrFile.toLowerCase()));
    const near = alike.length === 1 ? alike[0] : nearest(nameOrFile, names);
    throw new Failure(
      `There is no shipped species and no file "${nameOrFile}".${near ? ` Did you mean ${near}?` : ''} Shipped: ${names.join(', ')}.`,
    );
  }
  const file = shipped ? join(shippedFolder(), `${nameOrFile.toLowerCase()}.json`) : nameOrFile;
  const { species, faults } = parseSpecies(readText(file));
  if (faults) throw new Failure(faults.map((fault) => `${file}: ${faultText(fault)}`).join('\n'));
  return species;
}
