import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import type { BakePlan, Shard } from './bake-plan.ts';
import { sha256 } from './bake-plan.ts';
import type { BakedTree } from './bake-tree.ts';
import { Failure } from './failure.ts';
import { readText } from './species-files.ts';
import { writeWhole } from './write-file.ts';

/** What a shard, or all of them together, have made. */
interface Manifest {
  readonly format: 'windgrove-bake';
  readonly version: 1;
  /** The program that baked, the hash of what was asked for, and what that was. */
  readonly windgrove: string;
  readonly plan: string;
  readonly species: readonly { readonly id: string; readonly name: string; readonly sha256: string }[];
  readonly seeds: string;
  readonly wind: string;
  readonly as: string;
  readonly options: unknown;
  /** Trees of all shards together. */
  readonly count: number;
  readonly shard?: string;
  readonly trees: readonly BakedTree[];
}

const ALL = 'manifest.json';

/** The manifest of a shard; that of the only shard is the manifest of the bake. */
export const manifestName = ({ part, of }: Shard): string => (of === 1 ? ALL : `manifest-${part}-of-${of}.json`);

/** Everything that a manifest says before its trees. */
export function manifestHead(
  plan: BakePlan,
  planHash: string,
  windgrove: string,
  count: number,
): Omit<Manifest, 'trees'> {
  return {
    format: 'windgrove-bake',
    version: 1,
    windgrove,
    plan: planHash,
    species: plan.species.map(({ id, species }) => ({
      id,
      name: species.name,
      sha256: sha256(JSON.stringify(species)),
    })),
    seeds: plan.seeds,
    wind: plan.wind.id,
    as: plan.format,
    options: plan.options,
    count,
  };
}

/** Writes a manifest: a line a tree, in the order of the plan, so that two of them can be compared. */
function write(folder: string, name: string, head: Omit<Manifest, 'trees'>, trees: readonly BakedTree[]): void {
  const lines = trees.map((tree) => `    ${JSON.stringify(tree)}`);
  const text = JSON.stringify(head, null, 2).replace(/\n\}$/, '');
  writeWhole(join(folder, name), `${text},\n  "trees": [\n${lines.join(',\n')}\n  ]\n}\n`);
}

/** Writes the manifest of a shard. */
export function writeManifest(
  folder: string,
  shard: Shard,
  head: Omit<Manifest, 'trees'>,
  trees: Iterable<BakedTree>,
): string {
  const name = manifestName(shard);
  const sorted = [...trees].sort((a, b) => a.index - b.index);
  write(folder, name, shard.of === 1 ? head : { ...head, shard: `${shard.part}/${shard.of}` }, sorted);
  return name;
}

/** The trees of a shard whose manifest is there already, as a bake begins: none where there is none; a Failure where it is of another bake. */
export function manifestTrees(folder: string, shard: Shard, plan: string): readonly BakedTree[] {
  const file = join(folder, manifestName(shard));
  if (!existsSync(file)) return [];
  const manifest = manifestOf(file);
  if (manifest.plan === plan) return manifest.trees;
  throw new Failure(
    `${file}: is of a bake of other species, seeds or options. Choose another --out, or remove this file.`,
  );
}

/** Makes one manifest of those of all shards in a folder; the same, byte by byte, as that of a bake in one. Returns how many trees. */
export function mergeManifests(folder: string): { trees: number; failed: number } {
  const names = namesIn(folder);
  if (names.length === 0) throw new Failure(`${folder}: there are no manifests of shards (manifest-1-of-8.json) here.`);
  const read = names.map((name) => ({ name, manifest: manifestOf(join(folder, name)) }));
  const { name: firstName, manifest: first } = read[0]!;
  const of = Number(first.shard?.split('/')[1]);
  for (const { name, manifest } of read)
    if (manifest.plan !== first.plan || Number(manifest.shard?.split('/')[1]) !== of)
      throw new Failure(`${join(folder, name)}: is of another bake than ${firstName}. Keep one bake a folder.`);
  const there = new Set(read.map(({ manifest }) => manifest.shard));
  const missing = Array.from({ length: of }, (_, k) => `${k + 1}/${of}`).filter((shard) => !there.has(shard));
  if (missing.length > 0)
    throw new Failure(
      `${folder}: shard${missing.length > 1 ? 's' : ''} ${missing.slice(0, 20).join(', ')} not there yet.`,
    );
  const trees = read.flatMap(({ manifest }) => manifest.trees).sort((a, b) => a.index - b.index);
  if (trees.length !== first.count || trees.some((tree, k) => tree.index !== k))
    throw new Failure(
      `${folder}: the manifests have ${trees.length} trees, the bake ${first.count}. Bake the shards again.`,
    );
  const { shard: _, trees: __, ...head } = first;
  write(folder, ALL, head, trees);
  return { trees: trees.length, failed: trees.filter(({ error }) => error !== undefined).length };
}

function namesIn(folder: string): string[] {
  try {
    return readdirSync(folder)
      .filter((name) => /^manifest-\d+-of-\d+\.json$/.test(name))
      .sort();
  } catch (error) {
    throw new Failure(`${folder}: cannot be read (${(error as NodeJS.ErrnoException).code}).`);
  }
}

function manifestOf(file: string): Manifest {
  const text = readText(file);
  try {
    const value = JSON.parse(text) as Partial<Manifest>;
    if (value.format === 'windgrove-bake' && value.version === 1 && Array.isArray(value.trees))
      return value as Manifest;
  } catch {
    // Falls through: no manifest.
  }
  throw new Failure(`${file}: is no manifest of a bake.`);
}
