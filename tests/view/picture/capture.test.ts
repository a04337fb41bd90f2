import fc from 'fast-check';
import { Box3, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { CaptureTooLarge, mostPixels, openCapture } from '../../../src/view/picture/capture.ts';
import { fieldOfView } from '../../../src/view/picture/capture-stage.ts';
import { closeUp } from '../../../src/view/picture/close-up.ts';
import { tilesOf } from '../../../src/view/picture/tiles.ts';

describe('tiles', () => {
  it('make up the whole picture, without overlap, none too large', () => {
    fc.assert(
      fc.property(fc.integer({ min: 1, max: 16384 }), fc.integer({ min: 1, max: 16384 }), (width, height) => {
        const tiles = tilesOf({ width, height }, 4096);
        let area = 0;
        for (const tile of tiles) {
          expect(Math.max(tile.width, tile.height)).toBeLessThanOrEqual(4096);
          expect(tile.width * tile.height).toBeLessThanOrEqual(2 ** 23);
          expect([tile.x + tile.width <= width, tile.y + tile.height <= height]).toEqual([true, true]);
          area += tile.width * tile.height;
        }
        expect(area).toBe(width * height);
        expect(new Set(tiles.map(({ x, y }) => `${x} ${y}`)).size).toBe(tiles.length);
      }),
    );
  });

  it('are one where a GPU can draw it at once', () => {
    expect(tilesOf({ width: 3840, height: 2160 }, 8192)).toEqual([{ x: 0, y: 0, width: 3840, height: 2160 }]);
  });
});

describe('a capture', () => {
  const noTree = (): never => {
    throw new Error('It asked for a tree before it knew that there would be a picture.');
  };

  it('says how large it may be', () => {
    expect(mostPixels({ width: 10, height: 1 })).toBe(16384);
    expect(mostPixels({ width: 1, height: 1 })).toBe(11585);
    const open = () => openCapture({} as never, 'whole', { width: 20000, height: 10000, transparent: false }, noTree);
    expect(open).toThrow(CaptureTooLarge);
    expect(open).toThrow('16384');
    for (const width of [0, 1.5, -3, Number.NaN]) {
      expect(() => openCapture({} as never, 'whole', { width, height: 10, transparent: false }, noTree)).toThrow(
        RangeError,
      );
    }
  });

  it('shows at least what the screen shows', () => {
    expect(fieldOfView(1, 0.5, 2)).toBeCloseTo(30, 9);
    // As wide as the screen in a picture half as wide: twice as high.
    const twice = fieldOfView(1, 2, 1);
    expect(Math.tan((twice * Math.PI) / 360)).toBeCloseTo(2 * Math.tan((30 * Math.PI) / 360), 9);
  });
});

describe('a close-up', () => {
  it('holds the whole round in a box, with air around it, and no more', () => {
    const camera = new PerspectiveCamera(30, 0.8, 0.1, 200);
    camera.position.set(3, 1.6, 30);
    camera.lookAt(0, 6, 0);
    const box = new Box3(new Vector3(-3, 0, -3), new Vector3(3, 12, 3));
    const { x, y, part } = closeUp(box, camera);
    expect(part).toBeLessThan(0.95);
    let least = 1;
    for (let i = 0; i < 200; i++) {
      const point = new Vector3(3 * Math.cos(i), i % 2 ? 12 : 0, 3 * Math.sin(i)).project(camera);
      for (const place of [((point.x + 1) / 2 - x) / part, ((1 - point.y) / 2 - y) / part]) {
        expect(place).toBeGreaterThan(0.02);
        expect(place).toBeLessThan(0.98);
        least = Math.min(least, place, 1 - place);
      }
    }
    expect(least).toBeCloseTo(0.07, 2);
  });
});
