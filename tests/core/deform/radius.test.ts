import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  clampedFlare,
  flare,
  powerTaper,
  type Shape,
  stemRadius,
  taperRadius,
} from '../../../src/core/deform/radius.ts';

const plain: Shape = { taper: 1, flare: 0, lobes: 0, lobeDepth: 0, lobeFade: 0, bulges: 0, bulgeDepth: 0 };

describe('taper', () => {
  test.each([0, 0.5, 0.95, 1, 1.1, 1.5, 2, 2.4, 3])('%s: the slope is that of the radius', (taper) => {
    const [radius, length, h] = [0.3, 4, 1e-7];
    const at = (z: number) => taperRadius(z, taper, radius, length);
    for (let z = 0.005; z < 1; z += 0.0117) {
      const [r, slope] = at(z);
      const left = (at(z)[0] - at(z - h)[0]) / h;
      const right = (at(z + h)[0] - at(z)[0]) / h;
      // Where spheres meet, or a cone meets its round end, there are two slopes and either will do.
      if (Math.abs(left - right) < 0.02 * (1 + Math.abs(left)) && r > 0.02) {
        expect(Math.abs(slope - (left + right) / 2)).toBeLessThan(1e-3 * (1 + Math.abs(slope)));
      }
    }
  });

  test('is finite for every parameter, with slopes of at most a thousand lengths', () => {
    fc.assert(
      fc.property(
        fc.oneof(fc.constantFrom(0, 0.5, 1), fc.double({ min: 0, max: 1, noNaN: true })),
        fc.oneof(fc.constantFrom(0, 1, 2, 3), fc.double({ min: 0, max: 3, noNaN: true })),
        fc.constantFrom(0, 1e-9, 1e-4, 0.02, 1),
        fc.constantFrom(0, 1e-4, 0.5, 20),
        (z, taper, radius, length) => {
          const [r, slope] = taperRadius(z, taper, radius, length);
          expect(Number.isFinite(r) && Number.isFinite(slope)).toBe(true);
          expect(r).toBeGreaterThanOrEqual(-1e-12);
          expect(r).toBeLessThanOrEqual(radius + 1e-12);
          expect(Math.abs(slope)).toBeLessThanOrEqual(1000 * Math.max(length, radius));
        },
      ),
    );
  });

  test('row 21: the tapers that the paper names have its radii', () => {
    const at = (taper: number, z: number) => taperRadius(z, taper, 0.5, 4)[0];
    for (const z of [0, 0.3, 0.9]) expect(at(0, z)).toBeCloseTo(0.5, 12);
    expect(at(1, 0.25)).toBeCloseTo(0.375, 12);
    // 2: a cylinder to the last radius, then half a sphere; 3: spheres of the stem's radius, from the tip downwards.
    expect([at(2, 0.5), at(2, 0.875), at(2, 0.9375)]).toEqual([0.5, 0.5, expect.closeTo(Math.sqrt(0.1875), 12)]);
    expect([at(3, 0.875), at(3, 0.75), at(3, 0.625)]).toEqual([0.5, expect.closeTo(0, 12), 0.5]);
    // Between 2 and 3 the spheres below the last one deepen.
    expect(at(2.4, 0.75)).toBeCloseTo(0.5 * 0.6, 12);
  });

  test('closes at the tip from taper 1 on', () => {
    for (const taper of [1, 1.2, 1.999, 2, 2.7, 3]) expect(taperRadius(1, taper, 0.2, 3)[0]).toBeCloseTo(0, 12);
  });

  test("Skjermo's taper below 1 has a finite slope at the base", () => {
    expect(powerTaper(0, 1, 0.5)[1]).toBeCloseTo(-50, 6);
    expect(powerTaper(0, 1, 2)[1]).toBeCloseTo(0, 12);
  });
});

test('the slope of the whole radius is that of its product', () => {
  const shape: Shape = { taper: 1.1, flare: 0.8, lobes: 5, lobeDepth: 0.1, lobeFade: 0.7, bulges: 7, bulgeDepth: 0.06 };
  const h = 1e-6;
  for (let z = 0.01; z < 0.95; z += 0.037) {
    for (const turns of [0, 0.13, 0.5, 0.81]) {
      const at = (z: number, t: number) => stemRadius(shape, 0.3, 8, z, t)[0];
      const [r, byZ, q] = stemRadius(shape, 0.3, 8, z, turns);
      expect(byZ).toBeCloseTo((at(z + h, turns) - at(z - h, turns)) / (2 * h), 5);
      expect(q * r).toBeCloseTo((at(z, turns + h) - at(z, turns - h)) / (4 * Math.PI * h), 5);
    }
  }
});

test('the two sides of the seam have the same radius', () => {
  const shape: Shape = { ...plain, lobes: 7, lobeDepth: 0.2 };
  expect(stemRadius(shape, 1, 5, 0.3, 0)).toEqual(stemRadius(shape, 1, 5, 0.3, 1));
});

test("row 23: Weber & Penn's flare is as printed; the one that is drawn is a hundredth of Flare wider and has no crease", () => {
  for (let z = 0; z <= 1; z += 0.01) {
    const printed = (0.6 * (100 ** Math.max(0, 1 - 8 * z) - 1)) / 100 + 1;
    expect(clampedFlare(z, 0.6)[0]).toBeCloseTo(printed, 12);
    const wider = flare(z, 0.6)[0] - printed;
    if (z <= 0.125) expect(wider).toBeCloseTo(0.006, 12);
    else expect(Math.abs(wider - 0.003)).toBeLessThanOrEqual(0.003);
  }
});

test('a flare widens the foot by its factor and is nearly gone an eighth up', () => {
  expect(flare(0, 0.6)[0]).toBeCloseTo(1.6, 12);
  expect(flare(0.125, 0.6)[0]).toBeCloseTo(1.006, 12);
});
