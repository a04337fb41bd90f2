import { createHash } from 'node:crypto';
import type { ExportFormat, ExportOptions } from '../core/io/export-options.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { UsageError } from './failure.ts';

/** What is baked into every tree of a bake: the same for all its shards. */
export interface BakePlan {
  readonly species: readonly { readonly id: string; readonly species: Species }[];
  /** As it was given: '1..1000'. */
  readonly seeds: string;
  /** 'none': no files, only the manifest. */
  readonly format: ExportFormat | 'none';
  readonly options: ExportOptions | null;
  readonly wind: { readonly id: string; readonly wind: Wind };
}

/** One tree of a bake; `index` counts all trees of it, species by species. */
export interface BakeItem {
  readonly index: number;
  readonly species: number;
  readonly seed: number;
}

/** Part `part` (from 1) of `of` parts. */
export interface Shard {
  readonly part: number;
  readonly of: number;
}

/** More trees than these are a slip of the hand. */
const MOST_TREES = 10_000_000;
const MOST_SHARDS = 100_000;
const LARGEST_SEED = 0xffffffff;

/** A list of seeds: runs of whole numbers, first and last of each, growing. */
export type SeedRuns = readonly (readonly [first: number, last: number])[];

/** The seeds of '1..1000', '7' or '1..10,20,30..40'. */
export function parseSeeds(text: string): SeedRuns {
  const wrong = (found: string): UsageError =>
    new UsageError(
      `--seeds: found "${found}"; allowed: whole numbers from 0 to ${LARGEST_SEED}, growing, as 7, 1..1000 or 1..10,20,30..40.`,
    );
  const runs = text.split(',').map((part): readonly [number, number] => {
    const [, first, last] = /^(\d{1,10})(?:\.\.(\d{1,10}))?$/.exec(part.trim()) ?? [];
    if (first === undefined) throw wrong(part);
    const run = [Number(first), Number(last ?? first)] as const;
    if (run[1] > LARGEST_SEED || run[1] < run[0]) throw wrong(part);
    return run;
  });
  for (let i = 1; i < runs.length; i++) if (runs[i]![0] <= runs[i - 1]![1]) throw wrong(text);
  return runs;
}

const seedCount = (runs: SeedRuns): number => runs.reduce((sum, [first, last]) => sum + last - first + 1, 0);

/** '3/8' as the third of eight shards. */
export function parseShard(text: string): Shard {
  const [, part, of] = /^(\d{1,6})\/(\d{1,6})$/.exec(text) ?? [];
  const shard = { part: Number(part), of: Number(of) };
  if (part === undefined || shard.part < 1 || shard.of > MOST_SHARDS || shard.part > shard.of)
    throw new UsageError(`--shard: found "${text}"; allowed: K/N with K from 1 to N and N up to ${MOST_SHARDS}.`);
  return shard;
}

/** How many trees a plan has in all its shards. */
export function treeCount(species: number, runs: SeedRuns): number {
  const count = species * seedCount(runs);
  if (count > MOST_TREES) throw new UsageError(`--seeds: ${count} trees; allowed: up to ${MOST_TREES}.`);
  return count;
}

/** The trees of a shard, every n-th of all, so that each shard has as much of each species. */
export function itemsOf(species: number, runs: SeedRuns, { part, of }: Shard): BakeItem[] {
  const items: BakeItem[] = [];
  let index = 0;
  for (let s = 0; s < species; s++)
    for (const [first, last] of runs)
      for (let seed = first; seed <= last; seed++, index++)
        if (index % of === part - 1) items.push({ index, species: s, seed });
  return items;
}

/** What tells one plan from another: a hash of all that decides its trees and files. */
export const planHash = (plan: BakePlan, version: string): string => sha256(JSON.stringify({ version, ...plan }));

export const sha256 = (content: string | Uint8Array): string => createHash('sha256').update(content).digest('hex');
