import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { parseArgs } from 'node:util';
import { bakeCommand, mergeCommand } from './bake.ts';
import { exportCommand } from './export.ts';
import { Failure, UsageError } from './failure.ts';
import { helpText } from './help.ts';
import { EXPORT_FLAGS, type FlagValues } from './option-flags.ts';
import { findSpecies } from './species-files.ts';
import { measure, statsText } from './stats.ts';
import type { Streams } from './streams.ts';
import { validate } from './validate.ts';

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

/** Options besides those of an export, and the commands that read them. */
const OPTIONS = {
  help: { type: 'boolean', short: 'h' },
  version: { type: 'boolean', short: 'v' },
  json: { type: 'boolean' },
  seed: { type: 'string' },
  seeds: { type: 'string' },
  shard: { type: 'string' },
  jobs: { type: 'string' },
  merge: { type: 'string' },
  out: { type: 'string' },
  wind: { type: 'string' },
} as const;

const FLAGS = Object.keys(EXPORT_FLAGS);

const READ: Readonly<Record<string, readonly string[]>> = {
  stats: ['seed', 'json'],
  validate: [],
  export: ['seed', 'out', 'wind', ...FLAGS],
  bake: ['seeds', 'shard', 'jobs', 'merge', 'out', 'wind', ...FLAGS],
};

/** Whether argument i is an option that takes a value and has a number below zero behind it. */
const isNegative = (args: readonly string[], i: number): boolean =>
  /^--[a-z-]+$/.test(args[i] ?? '') && /^-\d/.test(args[i + 1] ?? '');

type Values = {
  readonly [Name in keyof typeof OPTIONS]?: (typeof OPTIONS)[Name]['type'] extends 'string' ? string : boolean;
};

function parse(args: readonly string[]): { values: Values & FlagValues; positionals: string[] } {
  try {
    // Node takes `--seed -1` for two options and asks what was meant; said as one it gets the answer that fits.
    const joined = args.flatMap((arg, i) =>
      isNegative(args, i) ? [`${arg}=${args[i + 1]}`] : isNegative(args, i - 1) ? [] : [arg],
    );
    const { values, positionals } = parseArgs({
      args: joined,
      options: { ...EXPORT_FLAGS, ...OPTIONS },
      allowPositionals: true,
    });
    return { values: values as Values & FlagValues, positionals };
  } catch (error) {
    throw new UsageError(error instanceof Error ? error.message : String(error));
  }
}

/** Throws where an option was given that the command does not read. */
function checkOptions(name: string, values: FlagValues): void {
  const read = READ[name];
  const wrong = Object.keys(values).find((option) => !read?.includes(option));
  if (!read || wrong === undefined) return;
  if (read.length === 0) throw new UsageError(`${name} takes no options.`);
  throw new UsageError(`${name} takes no --${wrong}; allowed: ${read.map((option) => `--${option}`).join(', ')}.`);
}

async function command(args: readonly string[], streams: Streams): Promise<number> {
  const { values, positionals } = parse(args);
  const { out, err } = streams;
  const [name, ...rest] = positionals;
  if (values.help || (name === 'help' && rest.length === 0)) {
    out(helpText());
    return 0;
  }
  if (values.version) {
    out(version());
    return 0;
  }
  const all: FlagValues = { ...values };
  const flags: FlagValues = Object.fromEntries(FLAGS.map((flag) => [flag, all[flag]]));
  const format = typeof flags.format === 'string' ? flags.format : undefined;
  if (name !== undefined) checkOptions(name, all);
  switch (name) {
    case 'stats': {
      if (rest.length !== 1) throw new UsageError('stats takes one SPECIES: a file or the name of a shipped species.');
      const measured = measure(findSpecies(rest[0]!, err).species, seedOf(values.seed));
      out(values.json ? JSON.stringify(measured.stats, null, 2) : statsText(measured));
      return 0;
    }
    case 'validate':
      if (rest.length === 0) throw new UsageError('validate takes at least one FILE.');
      return validate(rest, streams);
    case 'export':
      if (rest.length !== 1) throw new UsageError('export takes one SPECIES: a file or the name of a shipped species.');
      return exportCommand(
        { species: rest[0]!, seed: seedOf(values.seed), format, out: values.out, wind: values.wind, flags },
        streams,
      );
    case 'bake':
      if (values.merge === undefined)
        return bakeCommand(
          {
            species: rest,
            seeds: values.seeds,
            shard: values.shard,
            out: values.out,
            format,
            wind: values.wind,
            jobs: values.jobs,
            flags,
            version: version(),
          },
          streams,
        );
      if (rest.length > 0 || Object.keys(values).length > 1)
        throw new UsageError('bake --merge DIR takes nothing else.');
      return mergeCommand(values.merge, streams);
    case undefined:
      throw new UsageError('Say what to do: stats, validate, export or bake.');
    default:
      throw new UsageError(`There is no command "${name}": it is stats, validate, export or bake.`);
  }
}

/** Runs the command with the arguments after its name; returns the exit status. */
export async function run(args: readonly string[], streams: Streams): Promise<number> {
  try {
    return await command(args, streams);
  } catch (error) {
    streams.progress?.('');
    if (!(error instanceof Failure)) throw error;
    streams.err(error.message);
    if (error instanceof UsageError) streams.err('See windgrove --help.');
    return error.exitCode;
  }
}
