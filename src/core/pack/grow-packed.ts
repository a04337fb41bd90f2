import { GrowthCancelled } from '../grow/budget.ts';
import { type GrowOptions, grow } from '../grow/grow.ts';
import { NothingGrownError } from '../grow/nothing-grown.ts';
import { type TreeStats, treeStats } from '../grow/stats.ts';
import type { Tree } from '../grow/tree.ts';
import { attachLeaves } from '../pieces/attach-leaves.ts';
import { fitPieces } from '../pieces/fit-pieces.ts';
import type { LeafAttachments, Pieces } from '../pieces/pieces.ts';
import type { Species } from '../species/species.ts';
import { packTree } from './pack.ts';
import type { PackedTree } from './packed.ts';
import { type StemTable, stemTable } from './stem-table.ts';

export type GrowStage = 'grow' | 'fit' | 'pack';

export interface GrowPackedOptions extends Omit<GrowOptions, 'onProgress'> {
  /** Milliseconds from any start: core has no clock of its own. Without it all times are 0. */
  readonly now?: () => number;
  /** Told how far it is: the stage, and the part of it that is done, 0..1. */
  readonly onProgress?: (stage: GrowStage, done: number) => void;
}

/** A tree from a species to what the GPU reads. */
export interface GrownPacked {
  readonly packed: PackedTree;
  readonly stats: TreeStats;
  /** What a page says of the stems; no part of the packed tree's hash. */
  readonly stems: StemTable;
  /** How long each stage took. */
  readonly milliseconds: Readonly<Record<GrowStage, number>>;
  /** What was packed; `pieces.stem` leads from what is drawn back to the stem. */
  readonly tree: Tree;
  readonly pieces: Pieces;
  readonly attachments: LeafAttachments;
}

/**
 * Grows, fits and packs a tree: the one way from a species to the GPU, for Node, the worker and tests.
 *
 * The same species, seed and options give the same arrays bit for bit. Throws GrowthBudgetError and GrowthCancelled as `grow`, and
 * NothingGrownError where there is no stem.
 */
export function growPacked(species: Species, seed: number, options: GrowPackedOptions = {}): GrownPacked {
  const { now = () => 0, onProgress, ...growing } = options;
  const enter = (stage: GrowStage): number => {
    if (options.shouldCancel?.()) throw new GrowthCancelled();
    onProgress?.(stage, 0);
    return now();
  };
  const began = enter('grow');
  const tree = grow(species, seed, { ...growing, onProgress: (done) => onProgress?.('grow', done) });
  if (tree.stems.count === 0) throw new NothingGrownError(species, seed);
  const grown = enter('fit');
  const pieces = fitPieces(tree);
  const attachments = attachLeaves(tree, pieces);
  const fitted = enter('pack');
  const packed = packTree(tree, pieces, attachments);
  const stems = stemTable(tree, pieces);
  const done = now();
  const milliseconds = { grow: grown - began, fit: fitted - grown, pack: done - fitted };
  const stats = treeStats(tree, { pieces, packed, milliseconds: done - began });
  onProgress?.('pack', 1);
  return { packed, stats, stems, milliseconds, tree, pieces, attachments };
}
