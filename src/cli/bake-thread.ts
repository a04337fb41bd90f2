import { parentPort, workerData } from 'node:worker_threads';
import type { BakeItem, BakePlan } from './bake-plan.ts';
import { type BakedTree, bakeTree } from './bake-tree.ts';

/** What a thread is started with. */
export interface ThreadStart {
  readonly plan: BakePlan;
  readonly folder: string;
}

/** What a thread says: that it is ready for its next tree, with its last, or why it has none. */
export type ThreadAnswer = { readonly done: BakedTree } | { readonly ready: true } | { readonly failed: string };

const { plan, folder } = workerData as ThreadStart;
const port = parentPort;
if (!port) throw new Error('bake-thread runs as a thread of windgrove bake.');

const answer = (message: ThreadAnswer): void => port.postMessage(message);

port.on('message', (item: BakeItem) => {
  bakeTree(plan, item, folder).then(
    (done) => answer({ done }),
    (error: unknown) => answer({ failed: error instanceof Error ? (error.stack ?? error.message) : String(error) }),
  );
});
answer({ ready: true });
