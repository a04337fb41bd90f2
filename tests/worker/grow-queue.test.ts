import { afterEach, describe, expect, it } from 'vitest';
import { GrowClient, isAborted } from '../../src/worker/client.ts';
import { GrowQueue } from '../../src/worker/grow-queue.ts';
import type { GrowRequest } from '../../src/worker/protocol.ts';
import { anySpecies } from '../core/pieces/hand-made-tree.ts';
import { FakeWorker } from './fake-worker.ts';

/** A service whose runs end when the test says so. */
class SlowService {
  readonly seeds: number[] = [];
  readonly #ends: ((tree: unknown) => void)[] = [];
  #heard: (() => void) | undefined;

  grow(request: GrowRequest): Promise<unknown> {
    this.seeds.push(request.seed);
    const grown = new Promise((resolve) => this.#ends.push(resolve));
    this.#heard?.();
    return grown;
  }

  /** Resolves when so many requests have come. */
  async came(count: number): Promise<void> {
    while (this.seeds.length < count) {
      await new Promise<void>((resolve) => {
        this.#heard = resolve;
      });
    }
  }

  end(run: number): void {
    this.#ends[run]?.({ stats: { seed: this.seeds[run] } });
  }
}

const queues: GrowQueue[] = [];
const workers: FakeWorker[] = [];

function queueOn(service: SlowService): GrowQueue {
  const client = new GrowClient(() => {
    const worker = new FakeWorker(service);
    workers.push(worker);
    return worker;
  }, 0);
  const queue = new GrowQueue(client);
  queues.push(queue);
  return queue;
}

afterEach(() => {
  for (const queue of queues.splice(0)) queue.dispose();
  workers.splice(0);
});

const reason = (promise: Promise<unknown>): Promise<unknown> =>
  promise.then(
    () => 'kept',
    (error) => (isAborted(error) ? error.reason : String(error)),
  );
const seedOf = async (promise: Promise<{ stats: { seed: number } }>): Promise<number> => (await promise).stats.seed;

describe('GrowQueue', () => {
  it('serves all askers with one worker, the most urgent first, as urgent as they are when their turn comes', async () => {
    const service = new SlowService();
    const queue = queueOn(service);
    let distance = 5;
    const far = queue.grow({}, { species: anySpecies, seed: 1, priority: () => 9 });
    const near = queue.grow({}, { species: anySpecies, seed: 2, priority: () => 1 });
    const nearing = queue.grow({}, { species: anySpecies, seed: 3, priority: () => distance });
    const middle = queue.grow({}, { species: anySpecies, seed: 4, priority: () => 3 });
    await service.came(1);
    distance = 2;
    for (let run = 0; run < 4; run++) {
      await service.came(run + 1);
      service.end(run);
    }
    expect(await Promise.all([far, near, nearing, middle].map(seedOf))).toEqual([1, 2, 3, 4]);
    expect(service.seeds).toEqual([2, 3, 4, 1]);
    expect(workers.length).toBe(1);
    expect(queue.length).toBe(0);
  });

  it('lets the latest request of an asker win, waiting or running, and leaves those of others', async () => {
    const service = new SlowService();
    const queue = queueOn(service);
    const [a, b] = [{}, {}];
    const running = reason(queue.grow(a, { species: anySpecies, seed: 1 }));
    await service.came(1);
    const other = queue.grow(b, { species: anySpecies, seed: 2, priority: () => 1 });
    const waiting = reason(queue.grow(b, { species: anySpecies, seed: 3, priority: () => 1 }));
    const latest = queue.grow(b, { species: anySpecies, seed: 4, priority: () => 1 });
    expect(await reason(other)).toBe('superseded');
    expect(await waiting).toBe('superseded');
    const again = queue.grow(a, { species: anySpecies, seed: 5 });
    expect(await running).toBe('superseded');
    await service.came(2);
    service.end(1);
    expect(await seedOf(again)).toBe(5);
    await service.came(3);
    service.end(2);
    expect(await seedOf(latest)).toBe(4);
    expect(service.seeds).toEqual([1, 5, 4]);
  });

  it('forgets what is cancelled, before and while it runs, and goes on with the others', async () => {
    const service = new SlowService();
    const queue = queueOn(service);
    const [first, second] = [new AbortController(), new AbortController()];
    const running = reason(queue.grow({}, { species: anySpecies, seed: 1, options: { signal: first.signal } }));
    await service.came(1);
    const waiting = reason(queue.grow({}, { species: anySpecies, seed: 2, options: { signal: second.signal } }));
    const last = queue.grow({}, { species: anySpecies, seed: 3, priority: () => 1 });
    second.abort();
    expect(await waiting).toBe('cancelled');
    first.abort();
    expect(await running).toBe('cancelled');
    await service.came(2);
    service.end(1);
    expect(await seedOf(last)).toBe(3);
    expect(service.seeds).toEqual([1, 3]);
    expect(
      await reason(queue.grow({}, { species: anySpecies, seed: 4, options: { signal: AbortSignal.abort() } })),
    ).toBe('cancelled');
  });

  it('ends its worker with everything that waits, and starts another when it is asked again', async () => {
    const service = new SlowService();
    const queue = queueOn(service);
    const promises = [1, 2].map((seed) => reason(queue.grow({}, { species: anySpecies, seed })));
    await service.came(1);
    queue.dispose();
    expect(await Promise.all(promises)).toEqual(['cancelled', 'cancelled']);
    expect(workers.every(({ terminated }) => terminated)).toBe(true);
    const again = queue.grow({}, { species: anySpecies, seed: 3 });
    await service.came(2);
    service.end(1);
    expect(await seedOf(again)).toBe(3);
  });
});
