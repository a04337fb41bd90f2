import { readdirSync, readFileSync } from 'node:fs';
import { join, relative, resolve, sep } from 'node:path';

/** Root of the repository. */
export const root = resolve(import.meta.dirname, '../..');

/** Folders that no commit holds: what tools and tests leave behind. */
const leftovers = new Set([
  'node_modules',
  '.git',
  'dist',
  'dist-cli',
  'dist-lib',
  'test-results',
  'playwright-report',
  'tmp',
]);

/** Paths of all files under a folder of the repository ('.' for all of it), with '/' between names, sorted. */
export function filesUnder(folder: string): string[] {
  const found: string[] = [];
  const walk = (path: string): void => {
    for (const entry of readdirSync(path, { withFileTypes: true })) {
      if (leftovers.has(entry.name)) continue;
      const child = join(path, entry.name);
      if (entry.isDirectory()) walk(child);
      else if (entry.isFile()) found.push(relative(root, child).split(sep).join('/'));
    }
  };
  walk(join(root, folder));
  return found.sort();
}

/** Text of a file of the repository. */
export const textOf = (file: string): string => readFileSync(join(root, file), 'utf8');
