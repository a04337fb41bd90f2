import { describe, expect, it } from 'vitest';
import { barkImage } from '../../../src/core/look/bark-image.ts';

describe.each(['smooth', 'furrowed', 'plated'] as const)('bark: %s', (kind) => {
  const size = 128;
  const { data } = barkImage(kind, size);
  const dark = (x: number, y: number) => data[((y & (size - 1)) * size + (x & (size - 1))) * 4];

  it('is the same each time', () => {
    expect(barkImage(kind, size).data).toEqual(data);
  });

  it('tiles: a step over the edge is no larger than the steps inside', () => {
    const steps = (at: (i: number, k: number) => number) => {
      let sum = 0;
      for (let i = 0; i < size; i++) sum += Math.abs(at(i, 0) - at(i, 1));
      return sum / size;
    };
    const acrossEdge = steps((i, k) => dark(k - 1, i)) + steps((i, k) => dark(i, k - 1));
    let inside = 0;
    for (let k = 4; k < size - 4; k++) inside += steps((i, j) => dark(k + j, i)) + steps((i, j) => dark(i, k + j));
    expect(acrossEdge).toBeLessThan((2.5 * inside) / (size - 8));
  });

  it('has light and dark, and relief both ways', () => {
    const spread = (channel: number) => {
      const values = Array.from({ length: size * size }, (_, i) => data[i * 4 + channel]).sort((a, b) => a - b);
      return values[Math.floor(values.length * 0.98)] - values[Math.floor(values.length * 0.02)];
    };
    expect(spread(0)).toBeGreaterThan(60);
    expect(spread(1)).toBeGreaterThan(20);
    expect(spread(2)).toBeGreaterThan(20);
  });
});
