import { describe, expect, it } from 'vitest';
import { leafGrowth } from '../../src/core/look/leaf-growth.ts';
import { leafTriangles } from '../../src/core/look/leaf-mesh.ts';
import { gridDetail, leafGrain, leavesDrawn, nearDepth } from '../../src/view/detail.ts';

describe('leaf budget', () => {
  it('keeps the cover: width times length grows as the leaves get fewer, a little less as they overlap less', () => {
    for (const ratio of [0.2, 0.66, 1, 2]) {
      const [width, length] = leafGrowth(0.25, ratio);
      expect(width * length).toBeCloseTo(4 ** 0.965, 12);
      expect(width).toBeGreaterThanOrEqual(length);
    }
    expect(leafGrowth(1, 0.2)).toEqual([1, 1]);
  });

  it('draws all leaves that can be told apart, and of smaller ones as many as cover the same at five pixels', () => {
    expect(leavesDrawn(10_000, 5, 1e6, 'auto')).toBe(10_000);
    expect(leavesDrawn(10_000, 40, 1e6, 'auto')).toBe(10_000);
    expect(leavesDrawn(10_000, 40, 300, 'auto')).toBe(300);
    for (const length of [4.9, 2, 0.7]) {
      const drawn = leavesDrawn(10_000, length, 1e6, 'auto');
      const grown = length * Math.sqrt(10_000 / drawn);
      expect(grown).toBeGreaterThanOrEqual(4.99);
      expect(grown).toBeLessThan(5.2);
    }
    expect(leavesDrawn(10_000, 0, 1e6, 'auto')).toBe(1);
  });

  it('draws stems too thin to be seen bending as ribbons of two parts', () => {
    expect(gridDetail(2, 1.2, 1000, 'auto')).toEqual({ sectors: 1, bands: 4 });
    expect(gridDetail(2, 0.9, 1000, 'auto')).toEqual({ sectors: 1, bands: 2 });
    // A piece of a dozen pixels is drawn straight.
    expect(gridDetail(2, 0.4, 1000, 'auto', 30)).toEqual({ sectors: 1, bands: 1 });
    expect(gridDetail(2, 0, 1000, 'auto', 30)).toEqual({ sectors: 1, bands: 1 });
    expect(gridDetail(2, 0.4, 1000, 'auto', 60)).toEqual({ sectors: 1, bands: 2 });
  });

  it('draws leaves coarser the smaller they are, and the more there are', () => {
    const each = leafTriangles({ shape: 0, width: 1, petiole: 0.6 }, 'middle');
    expect(leafGrain(100, Math.floor(200_000 / each), each, 'auto')).toBe('middle');
    expect(leafGrain(100, Math.ceil(200_000 / each) + 1, each, 'auto')).toBe('far');
    expect(leafGrain(Math.sqrt(32 * each) + 0.01, 1000, each, 'auto')).toBe('middle');
    expect(leafGrain(Math.sqrt(32 * each) - 0.01, 1000, each, 'auto')).toBe('far');
    expect(leafGrain(4, 1000, each, 'auto')).toBe('far');
    expect(leafGrain(4, 1000, each, 'high')).toBe('middle');
  });

  it('draws those finest whose triangles cover some pixels', () => {
    const leaf = { length: 0.1, triangles: 33, scale: 700, perspective: true };
    const depth = nearDepth(leaf, 'auto');
    expect((0.1 * 700) / depth).toBeCloseTo(Math.sqrt(53 * 33), 9);
    expect(nearDepth({ ...leaf, triangles: 4 * 33 }, 'auto')).toBeCloseTo(depth / 2, 9);
    expect(nearDepth(leaf, 'high')).toBeCloseTo(4 * depth, 9);
    expect(nearDepth(leaf, 'low')).toBe(0);
    // Without perspective all are or none is.
    expect(nearDepth({ ...leaf, scale: 419, perspective: false }, 'auto')).toBe(Number.POSITIVE_INFINITY);
    expect(nearDepth({ ...leaf, scale: 418, perspective: false }, 'auto')).toBe(0);
  });
});
