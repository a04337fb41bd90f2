import fc from 'fast-check';
import { FloatType } from 'three';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';
import { expect, test } from 'vitest';
import { writeExr } from '../../../src/core/io/exr.ts';
import { halfBits, halfValue } from '../../../src/core/io/half.ts';

test('a half is the nearest there is, and its bits mean what they did', () => {
  const known: [number, number][] = [
    [0, 0],
    [1, 0x3c00],
    [-2, 0xc000],
    [65504, 0x7bff],
    [65519.99, 0x7bff],
    [65520, 0x7c00],
    [1e9, 0x7c00],
    [2 ** -24, 1],
    [2 ** -14, 0x0400],
    [2 ** -25, 0],
    [0.333251953125, 0x3555],
    [1 + 2 ** -11, 0x3c00],
    [1 + 3 * 2 ** -11, 0x3c02],
    [Number.NaN, 0x7e00],
  ];
  for (const [value, bits] of known) expect([value, halfBits(value)]).toEqual([value, bits]);
  for (let bits = 0; bits < 0x7c00; bits++) {
    if (halfBits(halfValue(bits)) !== bits) throw new Error(`bits ${bits}`);
    if (halfBits(-halfValue(bits)) !== (bits | 0x8000)) throw new Error(`bits -${bits}`);
  }
  fc.assert(
    fc.property(fc.float({ min: -65000, max: 65000, noNaN: true }), (value) => {
      const error = Math.abs(halfValue(halfBits(value)) - value);
      expect(error).toBeLessThanOrEqual(Math.max(2 ** -25, Math.abs(value) * 2 ** -11));
    }),
  );
});

test.each([
  [1, 1],
  [5, 3],
  [256, 2],
])('an image of %i x %i is read by another program as it was written, bit by bit', (width, height) => {
  // Whatever is no infinity and not a number.
  const bits = Uint16Array.from({ length: 4 * width * height }, (_, i) => (i * 977 + 31) % 0x7c00);
  const loader = new EXRLoader();
  loader.type = FloatType;
  const read = loader.parse(writeExr(width, height, bits).buffer) as unknown as {
    width: number;
    height: number;
    data: Float32Array;
  };
  expect([read.width, read.height]).toEqual([width, height]);
  // three keeps rows from the bottom.
  for (let y = 0; y < height; y++) {
    const row = Array.from(read.data.subarray(4 * (height - 1 - y) * width, 4 * (height - y) * width), halfBits);
    expect(row).toEqual(Array.from(bits.subarray(4 * y * width, 4 * (y + 1) * width)));
  }
});

test('an image names its channels by alphabet, as the format asks and not every reader checks', () => {
  const head = new TextDecoder('latin1').decode(writeExr(1, 1, new Uint16Array(4)).subarray(0, 120));
  expect(['A', 'B', 'G', 'R'].map((name) => head.indexOf(`${name}\0\u0001\0\0\0`))).toEqual([28, 46, 64, 82]);
});
