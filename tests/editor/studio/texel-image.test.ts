import { describe, expect, test } from 'vitest';
import {
  amounts,
  paintAmounts,
  paintColours,
  pieceAt,
  reach,
  texelText,
} from '../../../src/editor/studio/texel-image.ts';
import type { TextureLayer } from '../../../src/view/picture/picture.ts';
import { textureImages } from '../../../src/view/picture/texture-images.ts';

const layer = (id: TextureLayer['id'], texels: readonly number[][]): TextureLayer => ({
  id,
  label: '',
  unit: '',
  data: Float32Array.from([...texels.flat(), 9, 9, 9, 9]),
});

describe('a texture', () => {
  const p3 = layer('P3', [
    [0, 0, 0, 1],
    [3, 4, 0, 1],
  ]);

  test('shows how far each piece has moved from its rest', () => {
    const rest = Float32Array.from([0, 0, 1, 0, 3, 4, 0, 0]);
    expect([...amounts(p3, 2, rest)]).toEqual([1, 0]);
    expect([...amounts(p3, 2, null)]).toEqual([0, 5]);
    // Velocities are no bend.
    expect([...amounts(layer('Q', [[3, 4, 100, 100]]), 1, null)]).toEqual([5]);
  });

  test('shows x, y, z as colours between their least and greatest; texels without a piece are clear', () => {
    const out = new Uint8ClampedArray(12);
    paintColours(p3, 2, out);
    expect([...out]).toEqual([0, 0, 128, 255, 255, 255, 128, 255, 0, 0, 0, 0]);
    expect(reach(p3, 2)).toEqual({ low: [0, 0, 0], high: [3, 4, 0] });
  });

  test('shows amounts from one colour to another', () => {
    const out = new Uint8ClampedArray(12);
    paintAmounts(new Float32Array([0, 25, 100]), 100, [200, 200, 200], [0, 100, 0], out);
    expect([...out]).toEqual([200, 200, 200, 255, 100, 150, 100, 255, 0, 100, 0, 255]);
    paintAmounts(new Float32Array([0]), 0, [1, 2, 3], [9, 9, 9], out);
    expect([...out.subarray(0, 4)]).toEqual([1, 2, 3, 255]);
  });

  test('says its four numbers with their names', () => {
    expect(texelText(p3, 1)).toEqual([
      { name: 'x', value: '3.0000', unit: 'm' },
      { name: 'y', value: '4.0000', unit: 'm' },
      { name: 'z', value: '0.0000', unit: 'm' },
      { name: 'leaves stirred', value: '1.0000', unit: 'm' },
    ]);
  });

  test('leads from a texel to its piece', () => {
    const images = { width: 16, height: 2, pieceCount: 20, layers: [] };
    expect([pieceAt(images, 0, 0), pieceAt(images, 3.9, 1.2), pieceAt(images, 4, 1)]).toEqual([0, 19, null]);
    expect([pieceAt(images, -0.1, 0), pieceAt(images, 16, 0), pieceAt(images, 0, 2)]).toEqual([null, null, null]);
  });

  test('has words for every texture that the picture gives', () => {
    const packed = { restPose: { width: 1, height: 1 }, pieceCount: 1 } as Parameters<typeof textureImages>[0];
    for (const each of textureImages(packed, new Float32Array(16), new Float32Array(12)).layers) {
      expect(texelText(each, 0).map(({ name }) => name)).toHaveLength(4);
    }
  });
});
