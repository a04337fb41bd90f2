import { BakeJournal } from './bake-journal.ts';
import { manifestHead, mergeManifests, writeManifest } from './bake-manifest.ts';
import { type BakePlan, itemsOf, parseSeeds, parseShard, planHash, treeCount } from './bake-plan.ts';
import { bakeAll } from './bake-pool.ts';
import { UsageError } from './failure.ts';
import { exportOptionsOf, type FlagValues, formatOf } from './option-flags.ts';
import { Progress } from './progress.ts';
import { findSpecies } from './species-files.ts';
import type { Streams } from './streams.ts';
import { DEFAULT_WIND, findWind } from './wind-files.ts';

/** What `windgrove bake` was asked for. */
export interface BakeCall {
  readonly species: readonly string[];
  readonly seeds: string | undefined;
  readonly shard: string | undefined;
  readonly out: string | undefined;
  readonly format: string | undefined;
  readonly wind: string | undefined;
  readonly jobs: string | undefined;
  readonly flags: FlagValues;
  /** Version of the program. */
  readonly version: string;
}

const MOST_JOBS = 256;

/** Bakes a shard of many trees, from where it was left, and writes its manifest. Returns 1 where a tree could not be grown. */
export async function bakeCommand(call: BakeCall, streams: Streams): Promise<number> {
  if (call.species.length === 0) throw new UsageError('bake takes at least one SPECIES.');
  if (call.seeds === undefined) throw new UsageError('bake takes --seeds, as --seeds 1..1000.');
  if (call.out === undefined) throw new UsageError('bake takes --out DIR, the folder to bake into.');
  const runs = parseSeeds(call.seeds);
  const shard = parseShard(call.shard ?? '1/1');
  const jobs = jobsOf(call.jobs);
  const format = call.format === 'none' ? 'none' : formatOf(call.format, undefined);
  const species = call.species.map((name) => findSpecies(name, streams.err));
  const twice = species.find(({ id }, i) => species.findIndex((other) => other.id === id) < i);
  if (twice) throw new UsageError(`There are two species "${twice.id}": their files would have the same names.`);
  const plan: BakePlan = {
    species,
    seeds: call.seeds,
    format,
    options: format === 'none' ? null : exportOptionsOf(call.flags, format),
    wind: findWind(call.wind ?? DEFAULT_WIND),
  };
  const count = treeCount(species.length, runs);
  const hash = planHash(plan, call.version);
  const journal = new BakeJournal(call.out, shard, hash);
  const all = itemsOf(species.length, runs, shard);
  const left = all.filter(({ index }) => !journal.done.has(index));
  const progress = new Progress(streams, all.length, all.length - left.length);
  if (left.length < all.length) streams.err(`${all.length - left.length} of ${all.length} trees were done before.`);
  const failedOf = (): number => [...journal.done.values()].filter(({ error }) => error !== undefined).length;
  let failed = failedOf();
  try {
    await bakeAll(plan, left, call.out, jobs, (tree) => {
      journal.add(tree);
      if (tree.error !== undefined) failed += 1;
      progress.show(journal.done.size, failed);
    });
  } finally {
    progress.end();
  }
  const name = writeManifest(call.out, shard, manifestHead(plan, hash, call.version, count), journal.done.values());
  journal.close();
  streams.out(`${all.length} trees in ${call.out}, listed in ${name}`);
  if (failed > 0) streams.err(`${failed} of them could not be grown: the manifest says why.`);
  return failed > 0 ? 1 : 0;
}

/** Makes one manifest of those of all shards. */
export function mergeCommand(folder: string, { out, err }: Streams): number {
  const { trees, failed } = mergeManifests(folder);
  out(`${trees} trees in ${folder}, listed in manifest.json`);
  if (failed > 0) err(`${failed} of them could not be grown: the manifest says why.`);
  return failed > 0 ? 1 : 0;
}

function jobsOf(text: string | undefined): number {
  if (text === undefined) return 1;
  if (/^\d{1,3}$/.test(text) && Number(text) >= 1 && Number(text) <= MOST_JOBS) return Number(text);
  throw new UsageError(`--jobs: found "${text}"; allowed: a whole number from 1 to ${MOST_JOBS}.`);
}
