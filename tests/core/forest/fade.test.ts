import { expect, it } from 'vitest';
import {
  ditherAt,
  type Fade,
  fadedOut,
  NEVER,
  treePixels,
  treeShare,
  treeShares,
} from '../../../src/core/forest/fade.ts';

it('shares every tree out among its classes without a hole and without a second time', () => {
  const near: Fade = [221, 299, NEVER, 2 * NEVER];
  const middle: Fade = [59.5, 80.5, 221, 299];
  const far: Fade = [-1, 0, 59.5, 80.5];
  for (let pixels = 0; pixels < 400; pixels += 3) {
    // Near trees have come to a third only: middle ones give up no more of themselves.
    for (const come of [0, 1 / 3, 1]) {
      const parts = [treeShares(near, pixels, come, 1), treeShares(middle, pixels, 1, come), treeShares(far, pixels)];
      const [n, m, f] = parts as [[number, number], [number, number], [number, number]];
      expect([n[0], n[1], m[1], f[1]]).toEqual([0, m[0], f[0], 1]);
    }
  }
});

it('measures a tree on screen from its middle, and comes in without a corner', () => {
  expect(treePixels([1, 2, 3], 10, [1, 42, 8], 500)).toBeCloseTo(125, 9);
  expect([treeShare(100, 200, 99), treeShare(100, 200, 150), treeShare(100, 200, 201)]).toEqual([0, 0.5, 1]);
  expect(treeShare(100, 200, 105)).toBeLessThan(0.01);
});

it('gives every pixel to one class, and to each its share of any patch of them', () => {
  const pixels = Array.from({ length: 1024 }, (_, i) => [(i % 32) + 0.5, Math.floor(i / 32) + 0.5] as const);
  const drawn = (shares: readonly [number, number]) => pixels.filter(([x, y]) => !fadedOut(x, y, shares));
  expect(drawn([0, 0.3]).length + drawn([0.3, 1]).length).toBe(1024);
  expect(Math.abs(drawn([0, 0.3]).length / 1024 - 0.3)).toBeLessThan(0.01);
  expect(drawn([0, 0]).length + drawn([0.3, 0.3]).length).toBe(0);
  expect(pixels.every(([x, y]) => ditherAt(x, y) >= 0 && ditherAt(x, y) < 1)).toBe(true);
});
