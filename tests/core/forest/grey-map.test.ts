import { encode } from 'fast-png';
import { describe, expect, test } from 'vitest';
import { faultText } from '../../../src/core/file/fault.ts';
import { forestDensity } from '../../../src/core/forest/density.ts';
import { readDensityMap, readHeightMap } from '../../../src/core/forest/grey-map.ts';
import { heightAt } from '../../../src/core/forest/height-field.ts';
import { mapField } from '../../../src/core/forest/terrain.ts';

type Image = Parameters<typeof encode>[0];
const png = (image: Image): Uint8Array => new Uint8Array(encode(image));
const grey16 = (side: number, value: (column: number, row: number) => number): Uint8Array =>
  png({
    width: side,
    height: side,
    data: Uint16Array.from({ length: side * side }, (_, i) => 65535 * value(i % side, Math.floor(i / side))),
    depth: 16,
    channels: 1,
  });
const grey8 = (width: number, height: number, at: (i: number) => number = () => 0): Uint8Array =>
  png({ width, height, data: Uint8Array.from({ length: width * height }, (_, i) => at(i)), channels: 1 });

describe('a height map', () => {
  test('of 16 bit gives metres between those of black and white, its top in the north', () => {
    const { map } = readHeightMap(
      grey16(33, (column, row) => (column + 32 - row) / 64),
      'hill.png',
    );
    const field = mapField(map!, 320, 100, 300);
    expect(heightAt(field, -160, -160)).toBeCloseTo(100, 1);
    expect(heightAt(field, 160, 160)).toBeCloseTo(300, 1);
    expect(heightAt(field, -160, 160)).toBeCloseTo(200, 1);
    expect(heightAt(field, 33.3, -12.7)).toBeCloseTo(200 + ((33.3 - 12.7) * 200) / 640, 1);
  });

  test('of 8 bit has no steps where the ground rises gently', () => {
    const side = 64;
    const gentle = grey8(side, side, (i) => Math.round(100 + (i % side) / 16));
    const field = mapField(readHeightMap(gentle, 'a.png').map!, side, 0, 255);
    const rises = Array.from({ length: 40 }, (_, i) => heightAt(field, i - 19, 0) - heightAt(field, i - 20, 0));
    expect(Math.max(...rises)).toBeLessThan(0.2);
    expect(Math.min(...rises)).toBeGreaterThan(0);
  });

  test('may be in grey colours, in a palette of greys, or transparent', () => {
    const data = Uint8Array.from({ length: 16 }, (_, i) => (i % 4 === 3 ? 255 : 51 * (i >> 2)));
    const { map } = readDensityMap(png({ width: 2, height: 2, data, channels: 4 }), 'a.png');
    expect([...map!.values].map((value) => Math.round(value * 5))).toEqual([2, 3, 0, 1]);
  });

  const colour = png({ width: 2, height: 2, data: new Uint8Array(12).fill(9).fill(200, 3, 4), channels: 3 });
  const bomb = grey8(2, 2).slice();
  new DataView(bomb.buffer).setUint32(16, 40_000);
  new DataView(bomb.buffer).setUint32(20, 40_000);
  const busy = grey8(64, 64, (i) => (i * 97) % 251);
  const spoilt = busy.slice();
  spoilt[60]! ^= 255;
  test.each([
    ['empty', new Uint8Array(), /found an empty file/],
    [
      'no picture',
      new TextEncoder().encode('{"format": "windgrove-forest"}'),
      /found no PNG picture; allowed: a height map: a grey PNG/,
    ],
    ['cut short', busy.slice(0, 300), /found a PNG picture that is damaged \(.*[^:]\); allowed/],
    ['spoilt within', spoilt, /found a PNG picture that is damaged \(.*data: invalid distance\); allowed/],
    ['of a head alone', grey8(4, 4).slice(0, 20), /ends in its head/],
    ['oblong', grey8(8, 4), /found 8 x 4 pixels, not a square; allowed: .*a square of 2 to 2049 pixels/],
    ['a single pixel', grey8(1, 1), /found 1 x 1 pixels/],
    ['far too large by its head', bomb, /found 40000 x 40000 pixels/],
    ['coloured', colour, /found a coloured picture \(pixel 1, 0 from the top left\); allowed: .*shades of grey/],
  ])('that is %s gives one clear fault', (_, bytes, message) => {
    const { map, fault } = readHeightMap(bytes, 'my\u001b hill.png');
    expect(map).toBeUndefined();
    expect(faultText(fault!)).toMatch(message);
    expect(faultText(fault!)).toMatch(/^my\\u001b hill\.png: /);
  });

  test('of densities is a density', () => {
    const { map } = readDensityMap(
      grey16(3, (column) => column / 2),
      'wood.png',
    );
    const field = forestDensity({ size: 100, density: { kind: 'map', name: 'wood.png' } }, map!);
    expect([...field.values.slice(0, 3)]).toEqual([0, 0.5, 1].map((v) => expect.closeTo(v, 4)));
    expect(faultText(readDensityMap(new Uint8Array(9), 'x').fault!)).toMatch(/a density map/);
  });
});
