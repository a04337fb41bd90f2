import type { Species } from '../core/species/species.ts';
import { type Hand, letGo, takeOn, WorkerFailed, type WorkerLike } from './hand.ts';
import {
  type GrownTree,
  type GrowProgress,
  type GrowService,
  type GrowSettings,
  PROTOCOL_VERSION,
} from './protocol.ts';
import { trustedWorker } from './trusted-worker.ts';

export type { WorkerLike } from './hand.ts';
export type { GrownTree, GrowProgress, GrowSettings } from './protocol.ts';

/** Why a promise was not kept although nothing is wrong: a newer request came, or the caller cancelled. */
export class GrowAborted extends Error {
  override readonly name = 'GrowAborted';
  readonly reason: 'superseded' | 'cancelled';
  constructor(reason: 'superseded' | 'cancelled') {
    super(reason === 'superseded' ? 'superseded: a newer tree was asked for' : 'cancelled: growing was stopped');
    this.reason = reason;
  }
}

/** True for the error of a promise that a newer request, or `cancel`, made idle: nothing to tell the user. */
export const isAborted = (error: unknown): error is GrowAborted => error instanceof GrowAborted;

export interface GrowOptions extends GrowSettings {
  /** Called while the tree grows, in the order of the stages; not after the promise is settled. */
  readonly onProgress?: (progress: GrowProgress) => void;
  /** Aborting it rejects the promise with `GrowAborted` ('cancelled'). */
  readonly signal?: AbortSignal;
}

/** Grows a tree without a worker, on the thread that asks. */
export type GrowHere = (species: Species, seed: number, options: GrowOptions) => Promise<GrownTree>;

interface Job {
  readonly species: Species;
  readonly seed: number;
  readonly options: GrowOptions;
  readonly keep: (tree: GrownTree) => void;
  readonly breakOff: (error: unknown) => void;
}

/**
 * Asks a worker for trees; the latest request wins.
 *
 * A running `grow` cannot hear that it is no longer wanted (that takes shared memory, which needs special headers). It gets
 * `patience` milliseconds from its start to end by itself, which keeps a warm worker for quick trees, and is then terminated
 * and a fresh worker started. So neither the page nor a newer request ever waits for a slow tree.
 */
export class GrowClient {
  private readonly spawn: () => WorkerLike;
  private readonly patience: number;
  private readonly here: GrowHere | null;
  /** A worker has answered: one that fails later died of its tree, which this thread had better not try. */
  private answered = false;
  private forbidden = false;
  private hand: Hand<GrowService> | null = null;
  /** Loads while an unwanted run has its patience, so that the next tree need not wait for it. */
  private spare: Hand<GrowService> | null = null;
  private running: Job | null = null;
  private waiting: Job | null = null;
  /** Does the worker grow something, wanted or not? */
  private busy = false;
  private startedAt = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** `here`: grows where no worker may start, as where a page's policy, or another origin, forbids it; without it requests reject then. */
  constructor(spawn: () => WorkerLike, patience = 150, here: GrowHere | null = null) {
    this.spawn = spawn;
    this.patience = patience;
    this.here = here;
  }

  /** Starts the worker before it is needed. */
  warmUp(): void {
    this.hand ??= this.start();
  }

  /** Grows, fits and packs a tree. Rejects with the worker's error, or with `GrowAborted`. */
  grow(species: Species, seed: number, options: GrowOptions = {}): Promise<GrownTree> {
    this.abort('superseded');
    return new Promise((resolve, reject) => {
      const { signal } = options;
      if (signal?.aborted) {
        reject(new GrowAborted('cancelled'));
        return;
      }
      const give = (): void => {
        if (job === this.running || job === this.waiting) this.cancel();
      };
      const settled = (): void => signal?.removeEventListener('abort', give);
      const job: Job = {
        species,
        seed,
        options,
        keep: (tree) => {
          settled();
          resolve(tree);
        },
        breakOff: (error) => {
          settled();
          reject(error);
        },
      };
      signal?.addEventListener('abort', give);
      this.waiting = job;
      if (this.busy) this.endInPatience();
      else this.next();
    });
  }

  /** Rejects what was asked for last, if it is not there yet, with `GrowAborted` ('cancelled'). */
  cancel(): void {
    this.abort('cancelled');
    if (this.busy) this.endInPatience();
  }

  /** Cancels and ends the worker. A later request starts another. */
  dispose(): void {
    this.abort('cancelled');
    this.end(this.spare);
    this.spare = null;
    this.dismiss();
  }

  private abort(reason: 'superseded' | 'cancelled'): void {
    this.running?.breakOff(new GrowAborted(reason));
    this.waiting?.breakOff(new GrowAborted(reason));
    this.running = null;
    this.waiting = null;
  }

  /** Terminates the run that nobody wants once its patience is over. */
  private endInPatience(): void {
    if (this.timer !== undefined) return;
    this.spare ??= this.start();
    const left = Math.max(0, this.startedAt + this.patience - performance.now());
    this.timer = setTimeout(() => {
      this.dismiss();
      this.next();
    }, left);
  }

  private stopTimer(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  private dismiss(): void {
    this.stopTimer();
    this.busy = false;
    this.end(this.hand);
    this.hand = this.spare;
    this.spare = null;
  }

  private end(hand: Hand<GrowService> | null): void {
    if (hand) letGo(hand);
  }

  /** A worker, or null where none may start. */
  private start(): Hand<GrowService> | null {
    if (this.forbidden) return null;
    try {
      return takeOn<GrowService>(this.spawn());
    } catch (error) {
      if (!this.here) throw error;
      this.forbidden = true;
      return null;
    }
  }

  private next(): void {
    const job = this.waiting;
    if (!job) return;
    this.waiting = null;
    this.running = job;
    this.busy = true;
    this.startedAt = performance.now();
    this.hand ??= this.start();
    if (this.hand) void this.run(this.hand, job);
    else void this.runHere(job);
  }

  private async runHere(job: Job): Promise<void> {
    const { onProgress, ...options } = job.options;
    const report = onProgress && ((p: GrowProgress) => this.running === job && onProgress(p));
    try {
      if (this.running === job && this.here)
        job.keep(await this.here(job.species, job.seed, { ...options, ...(report ? { onProgress: report } : {}) }));
    } catch (error) {
      job.breakOff(error);
    }
    if (this.running !== job) return;
    this.running = null;
    this.busy = false;
    this.stopTimer();
    this.next();
  }

  private async run(hand: Hand<GrowService>, job: Job): Promise<void> {
    const { species, seed } = job;
    const { onProgress, signal: _, ...settings } = job.options;
    const report = onProgress && ((p: GrowProgress) => this.running === job && onProgress(p));
    try {
      const asked = hand.service.grow({ version: PROTOCOL_VERSION, species, seed, settings }, report);
      // A promise that was broken off meanwhile is settled: this then does nothing.
      job.keep(await Promise.race([asked, hand.failed]));
      this.answered = true;
    } catch (error) {
      if (error instanceof WorkerFailed && this.here && !this.answered) {
        this.forbidden = true;
        if (this.hand === hand) this.hand = null;
        this.end(hand);
        return this.runHere(job);
      }
      job.breakOff(error);
      if (this.hand === hand && error instanceof WorkerFailed) this.dismiss();
    }
    if (this.running === job) this.running = null;
    // A worker that was dismissed has no say in what comes next.
    if (this.hand !== hand) return;
    this.busy = false;
    this.stopTimer();
    this.next();
  }
}

let shared: GrowClient | undefined;

const spawnWorker = (Worker = trustedWorker()): WorkerLike =>
  new Worker(new URL('./grow.worker.ts', import.meta.url), { type: 'module' });

/** A client with a worker of its own, for trees beside the page's. `here` as `GrowClient` takes it. */
export const newGrowClient = (here: GrowHere | null = null): GrowClient =>
  new GrowClient(() => spawnWorker(), undefined, here);

/** The page's own client: one worker, made when it is first used. */
export function growClient(): GrowClient {
  shared ??= newGrowClient();
  return shared;
}

/**
 * Grows a tree in the page's worker; the latest request wins, an older one rejects with `GrowAborted` ('superseded').
 *
 * Errors of the species reject with the name and message that they had in the worker.
 */
export const growInWorker = (species: Species, seed: number, options: GrowOptions = {}): Promise<GrownTree> =>
  growClient().grow(species, seed, options);
