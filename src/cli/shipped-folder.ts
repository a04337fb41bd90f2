import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { Failure } from './failure.ts';

/** A folder of files that ship, `species` or `winds`: beside the built command, or in the tree's public folder. */
export function shippedFolder(name: 'species' | 'winds'): string {
  const beside = join(import.meta.dirname, name);
  if (existsSync(beside)) return beside;
  for (let folder = import.meta.dirname; folder !== dirname(folder); folder = dirname(folder)) {
    const candidate = join(folder, 'public', name);
    if (existsSync(candidate)) return candidate;
  }
  throw new Failure(`The shipped ${name} are missing from this installation.`);
}
