import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { parseArgs } from 'node:util';
import { Failure, UsageError } from './failure.ts';
import { findSpecies, shippedNames } from './species-files.ts';
import { measure, statsText } from './stats.ts';
import type { Streams } from './streams.ts';
import { validate } from './validate.ts';

const help = (): string => `windgrove: trees with wind through every branch

Usage:
  windgrove stats SPECIES [--seed N] [--json]   grow a tree and print its figures
  windgrove validate FILE...                    check files of species and winds; exit status 1 where one has a fault
  windgrove --help | --version

SPECIES is a species file, or the name of a shipped one:
  ${shippedNames().join(', ')}
N is a whole number from 0 to 4294967295; 1 where it is left out.

Lengths are in metres, angles in degrees. Exit status: 0 all well, 1 a fault in a file or a tree too large, 2 a wrong call.`;

/** The version in the package.json above this file. */
function version(): string {
  for (let folder = import.meta.dirname; folder !== dirname(folder); folder = dirname(folder)) {
    try {
      const found: unknown = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
      if (typeof found === 'object' && found !== null && 'version' in found) return String(found.version);
    } catch {
      // Not in this folder: look in the one above.
    }
  }
  return 'unknown';
}

function seedOf(text: string | undefined): number {
  if (text === undefined) return 1;
  const seed = Number(text);
  if (/^\d+$/.test(text) && seed <= 0xffffffff) return seed;
  throw new UsageError(`--seed: found "${text}"; allowed: a whole number from 0 to 4294967295.`);
}

const OPTIONS = {
  help: { type: 'boolean', short: 'h' },
  version: { type: 'boolean', short: 'v' },
  json: { type: 'boolean' },
  seed: { type: 'string' },
} as const;

/** Whether argument i is `--seed` with a number below zero behind it. */
const isSeed = (args: readonly string[], i: number): boolean => args[i] === '--seed' && /^-\d/.test(args[i + 1] ?? '');

function parse(args: readonly string[]) {
  try {
    // Node takes `--seed -1` for two options and asks what was meant; said as one it gets the answer that fits.
    const joined = args.flatMap((arg, i) =>
      isSeed(args, i) ? [`--seed=${args[i + 1]}`] : isSeed(args, i - 1) ? [] : [arg],
    );
    return parseArgs({ args: joined, options: OPTIONS, allowPositionals: true });
  } catch (error) {
    throw new UsageError(error instanceof Error ? error.message : String(error));
  }
}

function command(args: readonly string[], { out, err }: Streams): number {
  const { values, positionals } = parse(args);
  const [name, ...rest] = positionals;
  if (values.help || (name === 'help' && rest.length === 0)) {
    out(help());
    return 0;
  }
  if (values.version) {
    out(version());
    return 0;
  }
  switch (name) {
    case 'stats': {
      if (rest.length !== 1) throw new UsageError('stats takes one SPECIES: a file or the name of a shipped species.');
      const measured = measure(findSpecies(rest[0]), seedOf(values.seed));
      out(values.json ? JSON.stringify(measured.stats, null, 2) : statsText(measured));
      return 0;
    }
    case 'validate':
      if (values.seed !== undefined || values.json) throw new UsageError('validate takes no options.');
      if (rest.length === 0) throw new UsageError('validate takes at least one FILE.');
      return validate(rest, { out, err });
    case undefined:
      throw new UsageError('Say what to do: stats or validate.');
    default:
      throw new UsageError(`There is no command "${name}": it is stats or validate.`);
  }
}

/** Runs the command with the arguments after its name; returns the exit status. */
export function run(args: readonly string[], streams: Streams): number {
  try {
    return command(args, streams);
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    streams.err(error.message);
    if (error instanceof UsageError) streams.err('See windgrove --help.');
    return error.exitCode;
  }
}
