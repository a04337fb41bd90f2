import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { DEFAULT_HILLS } from '../../../src/core/forest/default-forest.ts';
import { densityAt, forestDensity, fullDensity } from '../../../src/core/forest/density.ts';
import type { ForestDocument } from '../../../src/core/forest/forest.ts';
import { Sites } from '../../../src/core/forest/habitat.ts';
import { heightAt, levelField, normalAt, slopeAt } from '../../../src/core/forest/height-field.ts';
import { scatter } from '../../../src/core/forest/scatter.ts';
import { hillsField } from '../../../src/core/forest/terrain.ts';

const SIZE = 300;
const plain = (more: Partial<ForestDocument> = {}) => ({
  seed: 5,
  size: SIZE,
  count: 1200,
  spacing: 2.5,
  mix: [{ species: 'oak', share: 1 }],
  ...more,
});
const level = levelField(SIZE);
const full = fullDensity(SIZE);

/** Metres from each tree to the next. */
function nearest(xs: Float32Array, ys: Float32Array): number {
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < xs.length; i++) {
    for (let j = 0; j < i; j++) least = Math.min(least, Math.hypot(xs[i]! - xs[j]!, ys[i]! - ys[j]!));
  }
  return least;
}

/** At an edge there are trees on one side alone. */
const INNER = SIZE / 2 - 12;

/** Metres to the nearest of the first `count` trees from the place that is farthest from any. */
function largestHole(places: ReturnType<typeof scatter>, count: number): number {
  let most = 0;
  for (let x = -INNER; x <= INNER; x += 2) {
    for (let y = -INNER; y <= INNER; y += 2) {
      let least = Number.POSITIVE_INFINITY;
      for (let i = 0; i < count; i++) {
        const [dx, dy] = [places.x[i]! - x, places.y[i]! - y];
        least = Math.min(least, dx * dx + dy * dy);
      }
      most = Math.max(most, least);
    }
  }
  return Math.sqrt(most);
}

describe('the scatter of a forest', () => {
  test('gives the same trees to the same document, others to another seed, and fewer as a prefix of more', () => {
    const a = scatter(plain(), level, full);
    const more = scatter(plain({ count: 2000 }), level, full);
    expect(scatter(plain(), level, full)).toEqual(a);
    expect(more.x.slice(0, a.count)).toEqual(a.x);
    expect(more.variant.slice(0, a.count)).toEqual(a.variant);
    expect(scatter(plain({ seed: 6 }), level, full).x).not.toEqual(a.x);
  });

  test('keeps the spacing, and stands no more trees than there is room for', () => {
    const crowded = scatter(plain({ count: 20_000, spacing: 7 }), level, full);
    expect(nearest(crowded.x, crowded.y)).toBeGreaterThanOrEqual(7 - 1e-4);
    // Discs of 7 m in the densest random packing, and no fewer than such a packing has when hardly one more fits.
    expect(crowded.count).toBeGreaterThan(0.56 * (SIZE / 7) ** 2);
    expect(crowded.count).toBeLessThan(0.85 * (SIZE / 7) ** 2);
  });

  test('is spread evenly, and so is any prefix of it: no hole is much wider than as many trees leave', () => {
    const places = scatter(plain(), level, full);
    for (const count of [40, 120, 500, 1200]) {
      // A hexagonal lattice would leave holes of 0.62 spacings; trees thrown at random, some 1.5.
      const spacing = SIZE / Math.sqrt(count);
      expect(largestHole(places, count) / spacing, `${count} trees`).toBeLessThan(1.15);
      expect(nearest(places.x.slice(0, count), places.y.slice(0, count)) / spacing).toBeGreaterThan(0.35);
    }
  });

  test('stands on the ground, and bare where the density is 0', () => {
    const field = hillsField(DEFAULT_HILLS, SIZE);
    const clearings = forestDensity(
      { size: SIZE, density: { kind: 'clearings', seed: 2, bare: 0.4, scale: 70 } },
      null,
    );
    const bare = clearings.values.filter((value) => value === 0).length / clearings.values.length;
    expect(bare).toBeCloseTo(0.4, 2);
    const { count, x, y, z } = scatter(plain(), field, clearings);
    expect(count).toBe(1200);
    for (let i = 0; i < count; i++) {
      expect(z[i]).toBeCloseTo(heightAt(field, x[i]!, y[i]!), 3);
      expect(densityAt(clearings, x[i]!, y[i]!)).toBeGreaterThan(0);
    }
  });

  test('stands each species in its habitat alone, by its share where all may stand, and none where none may', () => {
    const field = hillsField({ ...DEFAULT_HILLS, relief: 40 }, SIZE);
    const range = (least: number, most: number) => ({ least, most, soft: 0 });
    const mix = [
      { species: 'oak', share: 0.5, where: { wetness: range(0.5, 1) } },
      { species: 'pine', share: 0.5, where: { wetness: range(0, 0.5), slope: range(2, 90) } },
    ];
    const { count, x, y, species } = scatter(plain({ mix }), field, full);
    const sites = new Sites(field, mix);
    const stood = [0, 0];
    for (let i = 0; i < count; i++) {
      const { wetness, slope } = sites.at(x[i]!, y[i]!);
      if (species[i] === 0) expect(wetness).toBeGreaterThanOrEqual(0.5);
      else expect(wetness <= 0.5 && slope >= 2).toBe(true);
      stood[species[i]!]!++;
    }
    expect(Math.min(...stood)).toBeGreaterThan(300);

    const shares = scatter(plain({ mix: [0.75, 0.25].map((share, i) => ({ species: `s${i}`, share })) }), level, full);
    expect(shares.species.filter((s) => s === 1).length / shares.count).toBeCloseTo(0.25, 1);
    const never = { species: 'palm', share: 1, where: { altitude: range(3000, 4000) } };
    expect(scatter(plain({ mix: [never] }), field, full).count).toBe(0);
  });
});

describe('hills', () => {
  test('slope and normal are those of the heights', () => {
    const field = hillsField({ ...DEFAULT_HILLS, rise: 90, relief: 30 }, SIZE);
    fc.assert(
      fc.property(
        fc.double({ min: -140, max: 140, noNaN: true }),
        fc.double({ min: -140, max: 140, noNaN: true }),
        (x, y) => {
          const [nx, ny, nz] = normalAt(field, x, y);
          expect(nx * nx + ny * ny + nz * nz).toBeCloseTo(1, 9);
          expect(Math.cos(slopeAt(field, x, y))).toBeCloseTo(nz, 9);
          const ahead = heightAt(field, x + 0.05, y) - heightAt(field, x - 0.05, y);
          expect(ahead / 0.1).toBeCloseTo(-nx / nz, 0);
        },
      ),
    );
    expect(heightAt(field, 0, 140) - heightAt(field, 0, -140)).toBeGreaterThan(50);
  });
});
