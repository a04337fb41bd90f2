import { expect, it } from 'vitest';
import { GrowClient } from '../../src/worker/client.ts';
import { growHere } from '../../src/worker/grow-here.ts';
import { growService } from '../../src/worker/service.ts';
import { anySpecies } from '../core/pieces/hand-made-tree.ts';
import { FakeWorker } from './fake-worker.ts';

const here: ConstructorParameters<typeof GrowClient>[2] = async (...wanted) => growHere(...wanted);

it('grows on this thread where starting a worker throws, and tries no other', async () => {
  let tried = 0;
  const refuse = (): never => {
    tried++;
    throw new DOMException('from another origin', 'SecurityError');
  };
  const client = new GrowClient(refuse, 150, here);
  const stages: string[] = [];
  const { stats } = await client.grow(anySpecies, 5, { onProgress: ({ stage }) => stages.push(stage) });
  expect(stats.seed).toBe(5);
  expect(new Set(stages)).toEqual(new Set(['grow', 'fit', 'pack']));
  expect((await client.grow(anySpecies, 6)).stats.seed).toBe(6);
  expect(tried).toBe(1);
  await expect(new GrowClient(refuse).grow(anySpecies, 5)).rejects.toThrow('from another origin');
});

it('grows on this thread where the worker’s script does not load; the latest of several requests', async () => {
  const worker = new FakeWorker({ grow: () => new Promise(() => {}) });
  const client = new GrowClient(() => worker, 150, here);
  const first = client.grow(anySpecies, 1).catch((error: Error) => error.name);
  const second = client.grow(anySpecies, 2);
  worker.fail('');
  expect(await first).toBe('GrowAborted');
  expect((await second).stats.seed).toBe(2);
});

it('does not grow on this thread what a worker died of', async () => {
  const worker = new FakeWorker(growService);
  const client = new GrowClient(() => worker, 150, here);
  await client.grow(anySpecies, 1);
  const asked = client.grow(anySpecies, 2);
  worker.fail('out of memory');
  await expect(asked).rejects.toThrow('out of memory');
});
