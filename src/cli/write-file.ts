import { mkdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { Failure } from './failure.ts';

/**
 * Writes a file that is whole or not there: under another name first, which then becomes its own. What a kill leaves of that is written over
 * by whoever writes the file again. Throws a Failure where it cannot.
 */
export function writeWhole(file: string, content: string | Uint8Array): void {
  const unfinished = `${file}.part`;
  try {
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(unfinished, content);
    renameSync(unfinished, file);
  } catch (error) {
    discard(unfinished);
    throw cannotWrite(file, error);
  }
}

/** What is said of a file or folder that cannot be written. */
export const cannotWrite = (file: string, error: unknown): Failure =>
  new Failure(`${file}: cannot be written (${(error as NodeJS.ErrnoException).code ?? String(error)}).`);

function discard(file: string): void {
  try {
    rmSync(file, { force: true });
  } catch {
    // Where it could not be written it may not be there: what went wrong first is what is said.
  }
}
