import fc from 'fast-check';
import { expect, test } from 'vitest';
import { texelRectangles } from '../../src/gpu/texel-ranges.ts';

const indices = (start: number, end: number, width: number) =>
  texelRectangles(start, end, width)
    .flatMap(([x0, y0, x1, y1]) => {
      const found: number[] = [];
      for (let y = y0; y < y1; y++) for (let x = x0; x < x1; x++) found.push(y * width + x);
      return found;
    })
    .sort((a, b) => a - b);

test('the rectangles hold each index of the range once and no other', () => {
  fc.assert(
    fc.property(fc.nat(200), fc.nat(200), fc.integer({ min: 0, max: 5 }), (start, count, log) => {
      const expected = Array.from({ length: count }, (_, i) => start + i);
      expect(indices(start, start + count, 2 ** log)).toEqual(expected);
    }),
  );
});

test('a range is at most three rectangles, and whole rows are one', () => {
  expect(texelRectangles(3, 21, 8)).toEqual([
    [3, 0, 8, 1],
    [0, 1, 8, 2],
    [0, 2, 5, 3],
  ]);
  expect(texelRectangles(8, 32, 8)).toEqual([[0, 1, 8, 4]]);
  expect(texelRectangles(0, 5, 8)).toEqual([[0, 0, 5, 1]]);
  expect(texelRectangles(5, 5, 8)).toEqual([]);
});
