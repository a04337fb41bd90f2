import { GrowAborted } from './client.ts';
import { GROVE_PROTOCOL_VERSION, type GroveRequest, type GroveService, type GrownGrove } from './grove-protocol.ts';
import { type Hand, letGo, takeOn, WorkerFailed, type WorkerLike } from './hand.ts';
import { trustedWorker } from './trusted-worker.ts';

export { isAborted } from './client.ts';
export type { GroveForm, GroveMember, GroveRequest, GrownGrove } from './grove-protocol.ts';

/** A grove that was asked for and may still be waiting. */
export interface GroveTicket {
  /** Rejects with the worker's error, or with `GrowAborted` ('cancelled'). */
  readonly done: Promise<GrownGrove>;
  /** Of those that wait the least comes first: metres to the camera, say. May be set while it waits. */
  priority: number;
  /** Not wanted any more; nothing happens where it is done. */
  cancel(): void;
}

interface Job {
  readonly id: number;
  readonly request: GroveRequest;
  readonly ticket: GroveTicket;
  readonly keep: (grown: GrownGrove) => void;
  readonly breakOff: (error: unknown) => void;
}

interface GroveHand extends Hand<GroveService> {
  job: Job | null;
}

/** Asks one or two workers for groves, the most urgent first. Each worker has one grove at a time; the others wait here, where they can change. */
export class GroveClient {
  readonly #spawn: () => WorkerLike;
  readonly #most: number;
  readonly #hands: GroveHand[] = [];
  readonly #waiting = new Set<Job>();
  #ids = 0;

  /** `workers`: how many there are at most; they start when they are first needed. */
  constructor(spawn: () => WorkerLike, workers = 1) {
    this.#spawn = spawn;
    this.#most = workers;
  }

  grow(request: GroveRequest, priority: number): GroveTicket {
    const id = ++this.#ids;
    let keep: Job['keep'] = () => {};
    let breakOff: Job['breakOff'] = () => {};
    const done = new Promise<GrownGrove>((resolve, reject) => {
      keep = resolve;
      breakOff = reject;
    });
    const ticket: GroveTicket = { done, priority, cancel: () => this.#cancel(job) };
    const job: Job = { id, request, ticket, keep, breakOff };
    this.#waiting.add(job);
    // Once the caller has asked for all that it wants, the nearest of them comes first.
    queueMicrotask(() => this.#next());
    return ticket;
  }

  /** Cancels everything and ends the workers. A later request starts others. */
  dispose(): void {
    for (const job of this.#waiting) job.breakOff(new GrowAborted('cancelled'));
    this.#waiting.clear();
    for (const hand of this.#hands.splice(0)) {
      hand.job?.breakOff(new GrowAborted('cancelled'));
      letGo(hand);
    }
  }

  #cancel(job: Job): void {
    const hand = this.#hands.find((each) => each.job === job);
    if (!this.#waiting.delete(job) && !hand) return;
    job.breakOff(new GrowAborted('cancelled'));
    // It stops after the tree that it is at, which is kept for whoever asks next.
    hand?.service.cancel(job.id).catch(() => undefined);
  }

  #next(): void {
    while (this.#waiting.size > 0) {
      const hand = this.#hands.find(({ job }) => job === null) ?? this.#start();
      if (!hand) return;
      let first: Job | null = null;
      for (const job of this.#waiting) if (!first || job.ticket.priority < first.ticket.priority) first = job;
      if (!first) return;
      this.#waiting.delete(first);
      void this.#run(hand, first);
    }
  }

  #start(): GroveHand | null {
    if (this.#hands.length >= this.#most) return null;
    const hand: GroveHand = { ...takeOn<GroveService>(this.#spawn()), job: null };
    this.#hands.push(hand);
    return hand;
  }

  async #run(hand: GroveHand, job: Job): Promise<void> {
    hand.job = job;
    try {
      const asked = hand.service.growGrove(GROVE_PROTOCOL_VERSION, job.id, job.request);
      // A promise that was broken off meanwhile is settled: this then does nothing.
      job.keep(await Promise.race([asked, hand.failed]));
    } catch (error) {
      job.breakOff(error);
      if (error instanceof WorkerFailed) {
        const at = this.#hands.indexOf(hand);
        if (at >= 0) this.#hands.splice(at, 1);
        letGo(hand);
      }
    }
    hand.job = null;
    this.#next();
  }
}

/** Two workers where there are cores for them beside the page and the editor's own worker. */
const workersHere = (): number => ((globalThis.navigator?.hardwareConcurrency ?? 2) > 4 ? 2 : 1);

const spawnWorker = (Worker = trustedWorker()): WorkerLike =>
  new Worker(new URL('./grove.worker.ts', import.meta.url), { type: 'module' });

/** A client with workers of its own. */
export const newGroveClient = (): GroveClient => new GroveClient(() => spawnWorker(), workersHere());
