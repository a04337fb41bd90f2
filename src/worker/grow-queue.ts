import type { Species } from '../core/species/species.ts';
import { GrowAborted, type GrowClient, type GrownTree, type GrowOptions, newGrowClient } from './client.ts';

/** What is asked for, by whom and how urgently. */
export interface QueuedGrowth {
  readonly species: Species;
  readonly seed: number;
  readonly options?: GrowOptions;
  /** The lower, the sooner; asked when the worker is free, since what is near may be far by then. */
  readonly priority?: () => number;
}

interface Job extends QueuedGrowth {
  readonly asker: object;
  readonly ended: AbortController;
  readonly keep: (tree: GrownTree) => void;
  readonly breakOff: (error: unknown) => void;
}

/** Many askers, one worker: each asker's latest request wins, those of others wait their turn, the most urgent first. */
export class GrowQueue {
  readonly #client: GrowClient;
  readonly #waiting = new Map<object, Job>();
  #running: Job | null = null;

  /** Uses a client that nobody else asks: another's request would supersede these. */
  constructor(client: GrowClient) {
    this.#client = client;
  }

  /** Requests that wait or run. */
  get length(): number {
    return this.#waiting.size + (this.#running ? 1 : 0);
  }

  /** Grows a tree for `asker`. Rejects with the worker's error, or with `GrowAborted`. */
  grow(asker: object, growth: QueuedGrowth): Promise<GrownTree> {
    this.#drop(asker, 'superseded');
    const { signal } = growth.options ?? {};
    if (signal?.aborted) return Promise.reject(new GrowAborted('cancelled'));
    const ended = new AbortController();
    const done = new Promise<GrownTree>((keep, breakOff) => {
      const job: Job = { ...growth, asker, ended, keep, breakOff };
      signal?.addEventListener('abort', () => this.#end(job, 'cancelled'), { signal: ended.signal });
      this.#waiting.set(asker, job);
    });
    // Once all have asked that ask now, the most urgent comes first.
    queueMicrotask(() => this.#next());
    return done;
  }

  /** Ends the worker; a later request starts another. */
  dispose(): void {
    for (const asker of [...this.#waiting.keys()]) this.#drop(asker, 'cancelled');
    if (this.#running) this.#drop(this.#running.asker, 'cancelled');
    this.#client.dispose();
  }

  #drop(asker: object, reason: 'superseded' | 'cancelled'): void {
    const job = this.#waiting.get(asker) ?? (this.#running?.asker === asker ? this.#running : undefined);
    if (job) this.#end(job, reason);
  }

  #end(job: Job, reason: 'superseded' | 'cancelled'): void {
    job.ended.abort();
    job.breakOff(new GrowAborted(reason));
    if (this.#waiting.get(job.asker) === job) this.#waiting.delete(job.asker);
    // The client gives an unwanted run a moment to end by itself, and then takes a fresh worker.
    else if (this.#running === job) {
      this.#running = null;
      queueMicrotask(() => this.#next());
    }
  }

  #next(): void {
    if (this.#running || this.#waiting.size === 0) return;
    let first: Job | undefined;
    let least = Number.POSITIVE_INFINITY;
    for (const job of this.#waiting.values()) {
      const rank = job.priority?.() ?? 0;
      if (first && rank >= least) continue;
      first = job;
      least = rank;
    }
    if (!first) return;
    this.#waiting.delete(first.asker);
    this.#running = first;
    void this.#run(first);
  }

  async #run(job: Job): Promise<void> {
    const { species, seed, options, ended } = job;
    try {
      job.keep(await this.#client.grow(species, seed, { ...options, signal: ended.signal }));
    } catch (error) {
      job.breakOff(error);
    }
    ended.abort(); // its listener on the caller's signal goes
    if (this.#running !== job) return;
    this.#running = null;
    this.#next();
  }
}

/** A queue with a worker of its own; where a page's policy, or another origin, forbids workers, its trees grow on this thread. */
export const newGrowQueue = (): GrowQueue =>
  new GrowQueue(newGrowClient(async (...wanted) => (await import('./grow-here.ts')).growHere(...wanted)));
