import { expect, test } from 'vitest';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { edit, shipped } from '../grow/species.ts';

test('a species whose trunk has no length is refused in words, not shown as an empty lawn', () => {
  const flat = edit(shipped('quaking-aspen'), { levels: { 0: { length: 0, lengthV: 0 } } });
  expect(() => growPacked(flat, 3)).toThrow(
    expect.objectContaining({
      name: 'NothingGrownError',
      message: 'The trunk has no length with seed 3. Raise levels[0].length, which is 0.',
    }),
  );
  const wild = edit(flat, { levels: { 0: { length: 0, lengthV: 0.00001 } } });
  expect(() => growPacked(wild, 3)).toThrow('or lower levels[0].lengthV, which is 0.00001.');
});
