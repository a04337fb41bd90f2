import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll } from 'vitest';
import { run } from '../../src/cli/run.ts';

/** Runs the command in this process as on a terminal, where progress is no line of its own, and gives what it wrote. */
export async function call(...args: string[]): Promise<{ status: number; out: string; err: string }> {
  const out: string[] = [];
  const err: string[] = [];
  const status = await run(args, {
    out: (line) => out.push(line),
    err: (line) => err.push(line),
    progress: () => {},
  });
  return { status, out: out.join('\n'), err: err.join('\n') };
}

/** A folder of the test's own, which goes when its file of tests is done. */
export function scratchFolder(): string {
  const folder = mkdtempSync(join(tmpdir(), 'windgrove-'));
  afterAll(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}
