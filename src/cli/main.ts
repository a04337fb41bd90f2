#!/usr/bin/env node
import { run } from './run.ts';

// Whoever reads may have read enough, as `head` does: that is no failure.
process.stdout.on('error', (error: NodeJS.ErrnoException) => {
  if (error.code !== 'EPIPE') throw error;
});

/** Back to the start of the line, which is cleared. */
const AGAIN = '\r\u001b[K';

process.exitCode = await run(process.argv.slice(2), {
  out: (line) => process.stdout.write(`${line}\n`),
  err: (line) => process.stderr.write(`${process.stderr.isTTY ? AGAIN : ''}${line}\n`),
  progress: process.stderr.isTTY ? (line) => process.stderr.write(AGAIN + line) : undefined,
});
