import { type GrownPacked, growPacked } from '../pack/grow-packed.ts';
import { inSeason } from '../species/season.ts';
import type { Species } from '../species/species.ts';
import type { Wind } from '../wind/wind.ts';
import type { ExportFile, ExportFormat, ExportOptions } from './export-options.ts';

/** What an export is at; a page has a word for each. */
export const EXPORT_STAGES = ['grow', 'mesh', 'wind', 'textures', 'write'] as const;
export type ExportStage = (typeof EXPORT_STAGES)[number];

/** Told what an export is at, and how much of all of it is done, 0..1 and never less than before. */
export type ReportExport = (stage: ExportStage, done: number) => void;

/** What a format is given. */
export interface ExportJob {
  readonly species: Species;
  readonly seed: number;
  readonly wind: Wind;
  readonly options: ExportOptions;
  /** Bare name for the files, without an ending: 'quaking-aspen-3'. */
  readonly name: string;
  /** The tree, grown when it is first asked for. */
  readonly grown: () => GrownPacked;
  readonly report: ReportExport;
}

/** Writes a tree as the files of one format. */
export type WriteFormat = (job: ExportJob) => Promise<ExportFile[]> | ExportFile[];

/** The formats, each loaded when it is asked for: their libraries are heavy. */
const FORMATS: Partial<Record<ExportFormat, () => Promise<WriteFormat>>> = {
  glb: async () => (await import('./glb/export-glb.ts')).exportGlb,
  obj: async () => (await import('./obj.ts')).exportObj,
  swc: async () => (await import('./swc.ts')).exportSwc,
  species: async () => (await import('./export-species.ts')).exportSpecies,
  channels: async () => (await import('./export-channels.ts')).exportChannels,
};

/** Part of the whole that growing is taken for. */
const GROWING = 0.15;

/**
 * A tree as files in the format that the options name.
 *
 * `known`: a bare name for the files in place of the species' own, and the tree where it is grown already. The same arguments give the
 * same bytes in Node and in a browser. Throws what growing throws, RangeError for options that a format
 * cannot satisfy, and whatever `report` throws, at once.
 */
export async function exportTree(
  species: Species,
  seed: number,
  wind: Wind,
  options: ExportOptions,
  report: ReportExport = () => {},
  known: { readonly name?: string; readonly grown?: GrownPacked } = {},
): Promise<ExportFile[]> {
  const load = FORMATS[options.format];
  if (!load) throw new RangeError(`There is no export as "${options.format}".`);
  const write = await load();
  let most = 0;
  const forwards: ReportExport = (stage, done) => {
    most = Math.min(1, Math.max(most, done));
    report(stage, most);
  };
  const dressed = options.format === 'species' ? species : inSeason(species, options.season);
  let grown = known.grown && inLook(known.grown, dressed);
  const grow = (): GrownPacked => {
    forwards('grow', 0);
    const parts = { grow: 0, fit: 0.7, pack: 0.9 } as const;
    const tree = growPacked(species, seed, {
      onProgress: (stage, done) =>
        forwards('grow', GROWING * Math.min(1, parts[stage] + (stage === 'grow' ? 0.7 : 0.1) * done)),
    });
    return inLook(tree, dressed);
  };
  const files = await write({
    species: dressed,
    seed,
    wind,
    options,
    name: known.name ?? fileName(species.name, seed),
    grown: () => {
      grown ??= grow();
      return grown;
    },
    // What a format reports is the part of its own work.
    report: (stage, done) => forwards(stage, grown ? GROWING + (1 - GROWING) * done : done),
  });
  forwards('write', 1);
  return files;
}

/** The same tree as it looks in a season. */
const inLook = (grown: GrownPacked, species: Species): GrownPacked => ({
  ...grown,
  tree: { ...grown.tree, species },
});

/** A bare file name for a tree: letters, digits and dashes. */
export function fileName(name: string, seed: number): string {
  const plain = name
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 60);
  return `${plain || 'tree'}-${seed}`;
}
