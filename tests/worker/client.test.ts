import { afterEach, describe, expect, it } from 'vitest';
import { growPacked } from '../../src/core/pack/grow-packed.ts';
import { hashPacked } from '../../src/core/pack/hash-packed.ts';
import { GrowAborted, GrowClient, isAborted } from '../../src/worker/client.ts';
import type { GrowRequest, GrowService } from '../../src/worker/protocol.ts';
import { growService } from '../../src/worker/service.ts';
import { anySpecies } from '../core/pieces/hand-made-tree.ts';
import { FakeWorker } from './fake-worker.ts';

/** A service whose runs end when the test says so. */
class SlowService {
  readonly asked: GrowRequest[] = [];
  private readonly ends: ((tree: unknown) => void)[] = [];
  grow(request: GrowRequest): Promise<unknown> {
    this.asked.push(request);
    this.heard?.();
    return new Promise((resolve) => this.ends.push(resolve));
  }
  /** Resolves when the next request arrives. */
  request(): Promise<void> {
    return new Promise((resolve) => {
      this.heard = resolve;
    });
  }
  private heard: (() => void) | undefined;
  end(run: number): void {
    this.ends[run]({ stats: { seed: this.asked[run].seed } });
  }
}

const clients: GrowClient[] = [];
const workers: FakeWorker[] = [];

function clientOf(service: GrowService | SlowService, patience?: number): GrowClient {
  const client = new GrowClient(() => {
    const worker = new FakeWorker(service);
    workers.push(worker);
    return worker;
  }, patience);
  clients.push(client);
  return client;
}

afterEach(() => {
  for (const client of clients.splice(0)) client.dispose();
  workers.splice(0);
});

const outcome = (promise: Promise<unknown>): Promise<unknown> => promise.catch((error) => error);

describe('GrowClient with the real service', () => {
  it('brings the same tree over as growing here, with stages told in order', async () => {
    const stages: string[] = [];
    const client = clientOf(growService);
    const grown = await client.grow(anySpecies, 5, {
      onProgress: ({ stage, done }) => stages.push(`${stage} ${done}`),
    });
    const here = growPacked(anySpecies, 5);
    expect(hashPacked(grown.packed)).toBe(hashPacked(here.packed));
    expect({ ...grown.stats, milliseconds: 0 }).toEqual(here.stats);
    expect(grown.stems).toEqual(here.stems);
    expect(grown.milliseconds.grow).toBeGreaterThan(0);
    const order = stages.map((s) => ['grow', 'fit', 'pack'].indexOf(s.split(' ')[0]));
    expect(order).toEqual([...order].sort());
    expect(stages).toContain('fit 0');
  });

  it('grows fewer levels and no leaves where it is told so', async () => {
    const client = clientOf(growService);
    const bare = await client.grow(anySpecies, 5, { leaves: false });
    expect(bare.packed.leafCount).toBe(0);
    const trunk = await client.grow(anySpecies, 5, { levels: 1 });
    expect(trunk.packed.levels).toHaveLength(1);
  });

  it("carries the species' error over and goes on", async () => {
    const client = clientOf(growService);
    const error = await outcome(client.grow(anySpecies, 5, { budget: { leaves: 10 } }));
    expect(error).toMatchObject({ name: 'GrowthBudgetError', message: expect.stringContaining('leaves') });
    expect((await client.grow(anySpecies, 5)).packed.leafCount).toBeGreaterThan(1000);
    expect(workers).toHaveLength(1);
  });
});

describe('GrowClient with a slow service', () => {
  it('lets the latest request win, and keeps a worker that ends in time', async () => {
    const service = new SlowService();
    const client = clientOf(service, 1e6);
    const first = outcome(client.grow(anySpecies, 1));
    await service.request();
    const second = outcome(client.grow(anySpecies, 2));
    const third = client.grow(anySpecies, 3);
    expect(await first).toMatchObject({ name: 'GrowAborted', reason: 'superseded' });
    expect(await second).toMatchObject({ name: 'GrowAborted', reason: 'superseded' });
    expect(service.asked).toHaveLength(1);
    const heard = service.request();
    service.end(0);
    await heard;
    service.end(1);
    expect((await third).stats.seed).toBe(3);
    // The second was never asked of the worker.
    expect(service.asked.map((r) => r.seed)).toEqual([1, 3]);
    // The spare that began to load was not needed.
    expect(workers.map((w) => w.asked)).toEqual([2, 0]);
    expect(workers.map((w) => w.terminated)).toEqual([false, false]);
  });

  it('terminates a worker that does not end in time and starts a fresh one', async () => {
    const service = new SlowService();
    const client = clientOf(service, 0);
    const first = outcome(client.grow(anySpecies, 1));
    await service.request();
    const heard = service.request();
    const second = client.grow(anySpecies, 2);
    expect(await first).toBeInstanceOf(GrowAborted);
    await heard;
    service.end(1);
    expect((await second).stats.seed).toBe(2);
    expect(workers.map((w) => w.terminated)).toEqual([true, false]);
  });

  it('cancels, by call and by signal', async () => {
    const service = new SlowService();
    const client = clientOf(service, 1e6);
    const called = outcome(client.grow(anySpecies, 1));
    client.cancel();
    expect(await called).toMatchObject({ reason: 'cancelled', message: expect.stringContaining('cancelled') });
    const control = new AbortController();
    const signalled = outcome(client.grow(anySpecies, 2, { signal: control.signal }));
    control.abort();
    expect(isAborted(await signalled)).toBe(true);
    expect(await outcome(client.grow(anySpecies, 3, { signal: control.signal }))).toMatchObject({
      reason: 'cancelled',
    });
  });

  it('says so when the worker breaks, and tries a new one next time', async () => {
    const service = new SlowService();
    const client = clientOf(service);
    const lost = outcome(client.grow(anySpecies, 1));
    await service.request();
    workers[0].fail('no such file');
    expect(await lost).toMatchObject({ message: 'The worker that grows trees stopped: no such file' });
    const heard = service.request();
    const next = client.grow(anySpecies, 2);
    await heard;
    service.end(1);
    expect((await next).stats.seed).toBe(2);
    expect(workers).toHaveLength(2);
  });
});
