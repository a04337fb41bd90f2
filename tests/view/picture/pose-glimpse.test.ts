import { expect, test } from 'vitest';
import { PoseGlimpse } from '../../../src/view/picture/pose-glimpse.ts';

test('the first pick asks, the next has the pose, until it is too old', async () => {
  let reads = 0;
  const glimpse = new PoseGlimpse(async () => new Float32Array([++reads]));
  expect(glimpse.at(5)).toBeNull();
  expect(glimpse.at(5)).toBeNull(); // it was asked for already
  await Promise.resolve();
  expect(glimpse.at(5)?.[0]).toBe(1);
  expect(reads).toBe(1);
  // Time runs: the old pose is still good, and a new one is on its way.
  expect(glimpse.at(5.2)?.[0]).toBe(1);
  await Promise.resolve();
  expect(glimpse.at(5.2)?.[0]).toBe(2);
  expect(glimpse.at(9)).toBeNull();
});

test('what was asked for before another tree came is not used, and a read that fails is no harm', async () => {
  const answers = [
    async () => new Float32Array(1),
    async () => {
      throw new Error('lost');
    },
    async () => null,
  ];
  const glimpse = new PoseGlimpse(() => (answers.shift() ?? (async () => new Float32Array([7])))());
  glimpse.at(1);
  glimpse.forget();
  for (let i = 0; i < 3; i++) {
    await new Promise((done) => setTimeout(done, 0));
    expect(glimpse.at(1)).toBeNull();
  }
  await new Promise((done) => setTimeout(done, 0));
  expect(glimpse.at(1)?.[0]).toBe(7);
});
