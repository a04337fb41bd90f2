import { createHash } from 'node:crypto';
import { describe, expect, it } from 'vitest';
import { barkImage } from '../../../src/core/look/bark-image.ts';
import { BARK_KINDS } from '../../../src/core/species/species.ts';

/** First digits of the SHA-256 of each tile of 64 texels a side: they change when the drawing does, and with nothing else. */
const HASHES: Readonly<Record<(typeof BARK_KINDS)[number], string>> = {
  smooth: '56f377332c72',
  furrowed: 'f0f37a17f0f8',
  plated: '29a99b3b3b9a',
  peeling: '8e7b02cca279',
  stringy: '5fee9870a13d',
  palm: '8c6d922102db',
  ribbed: 'b662c802e686',
  noded: 'd7d1004d69c9',
};

describe.each(BARK_KINDS)('bark: %s', (kind) => {
  const size = 128;
  const { data } = barkImage(kind, size);
  const at = (channel: number) => (x: number, y: number) =>
    data[((y & (size - 1)) * size + (x & (size - 1))) * 4 + channel];

  it('has the same bytes on every machine', () => {
    expect(createHash('sha256').update(barkImage(kind, 64).data).digest('hex').slice(0, 12)).toBe(HASHES[kind]);
  });

  it.each([
    ['darkness', 0],
    ['height', 3],
  ])('tiles in %s: a step over the edge is no larger than the largest inside', (_, channel) => {
    const texel = at(channel);
    const across = (k: number, step: (i: number, k: number) => number) => {
      let sum = 0;
      for (let i = 0; i < size; i++) sum += step(i, k);
      return sum / size;
    };
    for (const step of [
      (i: number, k: number) => Math.abs(texel(k, i) - texel(k - 1, i)),
      (i: number, k: number) => Math.abs(texel(i, k) - texel(i, k - 1)),
    ]) {
      const inside = Array.from({ length: size - 1 }, (_, k) => across(k + 1, step));
      expect(across(0, step)).toBeLessThanOrEqual(1.05 * Math.max(...inside));
    }
  });

  it('has light and dark, and relief both ways', () => {
    const spread = (channel: number) => {
      const values = Array.from({ length: size * size }, (_, i) => data[i * 4 + channel]).sort((a, b) => a - b);
      return values[Math.floor(values.length * 0.99)] - values[Math.floor(values.length * 0.01)];
    };
    expect(spread(0)).toBeGreaterThan(80);
    expect(spread(1)).toBeGreaterThan(20);
    expect(spread(2)).toBeGreaterThan(20);
    expect(spread(3)).toBeGreaterThan(40);
  });

  it('loses little to the ends of its range: its lights and its darks have detail', () => {
    let lost = 0;
    for (let i = 0; i < size * size; i++) if (data[4 * i] === 0 || data[4 * i] === 255) lost++;
    expect(lost / (size * size)).toBeLessThan(0.2);
  });
});
