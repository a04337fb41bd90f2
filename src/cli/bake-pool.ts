import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
import { Worker } from 'node:worker_threads';
import type { BakeItem, BakePlan } from './bake-plan.ts';
import type { ThreadAnswer, ThreadStart } from './bake-thread.ts';
import { type BakedTree, bakeTree } from './bake-tree.ts';
import { Failure } from './failure.ts';

/** Bakes items one after the other, `jobs` at a time, and hands on each tree as it is done, in any order. */
export async function bakeAll(
  plan: BakePlan,
  items: readonly BakeItem[],
  folder: string,
  jobs: number,
  done: (tree: BakedTree) => void,
): Promise<void> {
  if (jobs > 1 && items.length > 1) return withThreads(plan, items, folder, Math.min(jobs, items.length), done);
  for (const item of items) done(await bakeTree(plan, item, folder));
}

/** A thread of the built command; of its source, as tests and benches run it, by way of a loader of TypeScript, which threads do not inherit. */
function thread(workerData: ThreadStart): Worker {
  const ending = import.meta.url.endsWith('.ts') ? 'ts' : 'js';
  const file = new URL(`./bake-thread.${ending}`, import.meta.url);
  if (ending === 'js') return new Worker(file, { workerData });
  const tsx = pathToFileURL(createRequire(import.meta.url).resolve('tsx/package.json'));
  const loader = new URL('./dist/esm/api/index.mjs', tsx);
  const start = `import('${loader}').then(({ register }) => { register(); return import('${file}'); });`;
  return new Worker(start, { eval: true, workerData });
}

async function withThreads(
  plan: BakePlan,
  items: readonly BakeItem[],
  folder: string,
  jobs: number,
  done: (tree: BakedTree) => void,
): Promise<void> {
  let next = 0;
  let left = items.length;
  const threads: Worker[] = [];
  try {
    await new Promise<void>((finish, fail) => {
      const give = (worker: Worker): void => {
        const item = items[next];
        next += 1;
        if (item) worker.postMessage(item);
      };
      for (let k = 0; k < jobs; k++) {
        const worker = thread({ plan, folder });
        threads.push(worker);
        worker.on('error', fail);
        worker.on('message', (answer: ThreadAnswer) => {
          try {
            if ('failed' in answer) throw new Failure(answer.failed);
            if ('done' in answer) {
              done(answer.done);
              left -= 1;
            }
            if (left === 0) finish();
            else give(worker);
          } catch (error) {
            fail(error);
          }
        });
      }
    });
  } finally {
    await Promise.all(threads.map((worker) => worker.terminate()));
  }
}
