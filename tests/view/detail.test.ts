import { describe, expect, it } from 'vitest';
import { type Detail, gridDetail } from '../../src/view/detail.ts';

describe('grid of a level', () => {
  it('gets finer the thicker the stems are on screen, and thin branches become ribbons', () => {
    const sectors = [0.3, 1, 2, 5, 10, 30, 100].map((radius) => gridDetail(2, radius, 10, 'auto').sectors);
    expect(sectors).toEqual(sectors.toSorted((a, b) => a - b));
    expect(sectors[0]).toBe(1);
    expect(sectors.at(-1)).toBe(24);
  });

  it('keeps a trunk round', () => {
    expect(gridDetail(0, 0.1, 3, 'auto').sectors).toBeGreaterThanOrEqual(6);
  });

  it('gives trunks more bands than twigs, and one band to none', () => {
    const bands = [0, 1, 2, 3, 7].map((level) => gridDetail(level, 10, 10, 'auto').bands);
    expect(bands).toEqual(bands.toSorted((a, b) => b - a));
    expect(bands.at(-1)).toBeGreaterThanOrEqual(2);
  });

  it('stays within the triangles of its budget, down to ribbons', () => {
    const triangles = (pieces: number, detail: Detail) => {
      const { sectors, bands } = gridDetail(3, 50, pieces, detail);
      return { sectors, triangles: sectors * bands * 2 * pieces };
    };
    expect(triangles(100, 'auto').sectors).toBe(24);
    expect(triangles(10_000, 'auto').triangles).toBeLessThanOrEqual(240_000);
    expect(triangles(1_000_000, 'auto').sectors).toBe(1);
    expect(gridDetail(0, 50, 100_000, 'auto').sectors).toBe(1);
    expect(triangles(10_000, 'low').sectors).toBeLessThan(triangles(10_000, 'high').sectors);
  });
});
