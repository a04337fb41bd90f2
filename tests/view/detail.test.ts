import { describe, expect, it } from 'vitest';
import { type Detail, gridDetail, stemsDrawn } from '../../src/view/detail.ts';

describe('grid of a level', () => {
  it('gets finer the thicker the stems are on screen, and thin branches become ribbons', () => {
    const sectors = [0.3, 1, 2, 5, 10, 30, 100].map((radius) => gridDetail(2, radius, 10, 'auto').sectors);
    expect(sectors).toEqual(sectors.toSorted((a, b) => a - b));
    expect(sectors[0]).toBe(1);
    expect(sectors.at(-1)).toBe(24);
  });

  it('keeps a trunk round', () => {
    expect(gridDetail(0, 0.1, 3, 'auto').sectors).toBeGreaterThanOrEqual(6);
    // The canes of a shrub are many, and as thin as its branches.
    expect(gridDetail(0, 2, 25, 'auto').sectors).toBe(1);
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

describe('stems of a level', () => {
  it('are all drawn while a pixel sees them, then fewer the thinner they are, but never none', () => {
    expect(stemsDrawn(1000, 0.5, 'auto')).toBe(1000);
    const counts = [0.45, 0.2, 0.1, 0.05, 0.01, 0].map((radius) => stemsDrawn(1000, radius, 'auto'));
    expect(counts).toEqual(counts.toSorted((a, b) => b - a));
    expect(counts.at(-1)).toBe(100);
    expect(stemsDrawn(3, 1e-4, 'auto')).toBe(1);
    // What remains, widened by the rest, is as thick as the thinnest that is worth a ribbon.
    for (const radius of [0.4, 0.17, 0.06]) {
      const wide = (radius * 1000) / stemsDrawn(1000, radius, 'auto');
      expect(wide).toBeGreaterThan(0.445);
      expect(wide).toBeLessThan(0.5);
    }
  });
});
