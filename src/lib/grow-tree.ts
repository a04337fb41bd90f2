import type { Species } from '../core/species/species.ts';
import type { GrownTree, GrowOptions } from '../worker/client.ts';
import { type GrowQueue, newGrowQueue } from '../worker/grow-queue.ts';

/** What of a tree is grown, who is told how far it is, and how it is stopped. */
export type GrowTreeOptions = GrowOptions;

let queue: GrowQueue | null = null;

/**
 * Grows a tree in a worker, and on this thread where no worker may start; trees that are asked for at once come one after the other.
 *
 * The same species, seed and options give the same tree on every machine. `seed`: a whole number from 0. Rejects with `GrowAborted` where
 * `options.signal` stops it, and with an Error of the name `GrowthBudgetError` or `NothingGrownError` where the species asks for too much or
 * for nothing.
 *
 * @example
 * ```ts
 * import { growTree, shipped, WindTree } from 'windgrove';
 *
 * const species = await shipped.speciesOf('quaking-aspen');
 * const { packed, stats } = await growTree(species, 7);
 * const tree = new WindTree();
 * tree.setTree(packed, species);
 * console.log(`${stats.leaves} leaves`);
 * ```
 */
export function growTree(species: Species, seed: number, options: GrowTreeOptions = {}): Promise<GrownTree> {
  queue ??= newGrowQueue();
  return queue.grow({}, { species, seed, options });
}
