import { afterEach, describe, expect, it } from 'vitest';
import { growPacked } from '../../src/core/pack/grow-packed.ts';
import { hashPacked } from '../../src/core/pack/hash-packed.ts';
import { mergeTrees } from '../../src/core/pack/merge-trees.ts';
import { GroveClient, isAborted } from '../../src/worker/grove-client.ts';
import type { GroveMember, GroveRequest } from '../../src/worker/grove-protocol.ts';
import { groveService } from '../../src/worker/grove-service.ts';
import { bytesOf, TreeCache } from '../../src/worker/tree-cache.ts';
import { anySpecies } from '../core/pieces/hand-made-tree.ts';
import { FakeWorker } from './fake-worker.ts';

/** Quick to grow. */
const species = { ...anySpecies, leaves: { ...anySpecies.leaves, count: Math.sign(anySpecies.leaves.count) } };
const at = (seed: number, x = 0): GroveMember => ({ seed, x, y: 0, z: 0, turn: 0.5 });
const ask = (...members: GroveMember[]): GroveRequest => ({ species, members, form: 'full' });

/** A service whose groves end when the test says so. */
class SlowService {
  readonly asked: number[] = [];
  readonly cancelled: number[] = [];
  readonly #ends: ((error?: Error) => void)[] = [];
  #heard: (() => void) | undefined;
  growGrove(_version: number, id: number): Promise<unknown> {
    this.asked.push(id);
    this.#heard?.();
    return new Promise((resolve, reject) => {
      this.#ends.push((error) => (error ? reject(error) : resolve({ grown: id })));
    });
  }
  cancel(id: number): void {
    this.cancelled.push(id);
    this.#heard?.();
  }
  /** Resolves when the next message arrives. */
  message(): Promise<void> {
    return new Promise((resolve) => {
      this.#heard = resolve;
    });
  }
  end(run: number, error?: Error): void {
    this.#ends[run]?.(error);
  }
}

const clients: GroveClient[] = [];
const workers: FakeWorker[] = [];

function clientOf(service: object, count = 1): GroveClient {
  const client = new GroveClient(() => {
    const worker = new FakeWorker(service);
    workers.push(worker);
    return worker;
  }, count);
  clients.push(client);
  return client;
}

const outcome = (promise: Promise<unknown>): Promise<unknown> => promise.catch((error) => error);

afterEach(() => {
  for (const client of clients.splice(0)) client.dispose();
  workers.splice(0);
});

describe('GroveClient with the real service', () => {
  it('brings the same grove over as merging here, and grows no tree twice', async () => {
    const client = clientOf(groveService({ middle: (tree) => tree }));
    const first = await client.grow(ask(at(3, 1), at(4, 5), at(3, 9)), 1).done;
    const tree = (seed: number) => growPacked(species, seed).packed;
    const place = (seed: number, x: number) => ({ tree: tree(seed), x, y: 0, z: 0, turn: 0.5 });
    expect(hashPacked(first.packed)).toBe(hashPacked(mergeTrees([place(3, 1), place(4, 5), place(3, 9)])));
    expect(first.packed.treeCount).toBe(3);
    expect(first.light.data.some((v) => v < 255)).toBe(true);
    expect(first.grown).toBe(2);
    const second = await client.grow(ask(at(4), at(5)), 1).done;
    expect(second.grown).toBe(1);
  });

  it("carries the worker's error over and goes on", async () => {
    const client = clientOf(groveService({ middle: (tree) => tree }));
    const error = await outcome(client.grow({ ...ask(), members: [] }, 1).done);
    expect(error).toMatchObject({ name: 'RangeError', message: 'A grove needs at least one tree.' });
    expect((await client.grow(ask(at(1)), 1).done).packed.treeCount).toBe(1);
  });
});

describe('GroveClient with a slow service', () => {
  it('asks for the nearest first, as they are when the worker is free', async () => {
    const service = new SlowService();
    const client = clientOf(service);
    let heard = service.message();
    const [far, near, middle] = [30, 10, 20].map((metres) => client.grow(ask(at(1)), metres));
    await heard;
    expect(service.asked).toEqual([2]);
    far!.priority = 5;
    heard = service.message();
    service.end(0);
    expect(await near!.done).toMatchObject({ grown: 2 });
    await heard;
    expect(service.asked).toEqual([2, 1]);
    heard = service.message();
    service.end(1);
    await heard;
    service.end(2);
    expect(await middle!.done).toMatchObject({ grown: 3 });
    expect(service.asked).toEqual([2, 1, 3]);
  });

  it('cancels what waits without asking, and what is grown by telling the worker', async () => {
    const service = new SlowService();
    const client = clientOf(service);
    const heard = service.message();
    const [running, waiting] = [client.grow(ask(at(1)), 1), client.grow(ask(at(2)), 2)];
    const ends = [running, waiting].map(({ done }) => outcome(done));
    await heard;
    const told = service.message();
    waiting.cancel();
    running.cancel();
    expect((await Promise.all(ends)).every(isAborted)).toBe(true);
    await told;
    expect(service.cancelled).toEqual([1]);
    expect(service.asked).toEqual([1]);
  });

  it('gives two workers a grove each, and another worker for one that breaks', async () => {
    const service = new SlowService();
    const client = clientOf(service, 2);
    const heard = service.message();
    const first = outcome(client.grow(ask(at(1)), 1).done);
    await heard;
    const again = service.message();
    const second = client.grow(ask(at(2)), 2);
    await again;
    expect(workers).toHaveLength(2);
    workers[0]!.fail('no such file');
    expect(await first).toMatchObject({ message: 'The worker that grows trees stopped: no such file' });
    service.end(1);
    expect(await second.done).toMatchObject({ grown: 2 });
  });
});

describe('the worker between two trees', () => {
  it('stops where the grove is no longer wanted', async () => {
    const service = groveService({ middle: (tree) => tree });
    const growing = outcome(service.growGrove(1, 7, ask(at(1), at(2), at(3))));
    service.cancel(7);
    expect(await growing).toMatchObject({ message: expect.stringContaining('cancelled') });
    const kept = await service.growGrove(1, 8, ask(at(1)));
    expect(kept.grown).toBe(0);
  });

  it('keeps as many trees as bytes allow, those that were asked for last', () => {
    const { packed } = growPacked(species, 1, { levels: 1 });
    const cache = new TreeCache(2 * bytesOf(packed));
    cache.put('a', packed);
    cache.put('b', packed);
    cache.get('a');
    cache.put('c', packed);
    expect([cache.get('a'), cache.get('b'), cache.get('c')].map(Boolean)).toEqual([true, false, true]);
    expect(cache.bytes).toBe(2 * bytesOf(packed));
  });
});
