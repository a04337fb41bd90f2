import { describe, expect, it } from 'vitest';
import { BUNDLE, spreadOrder } from '../../../src/core/pack/spread.ts';

describe('spreadOrder', () => {
  it.each([0, 1, 2, 15, 16, 17, 63, 64, 65, 1000, 13500])('is a permutation of %i', (count) => {
    expect(Array.from(spreadOrder(count)).sort((a, b) => a - b)).toEqual(Array.from({ length: count }, (_, i) => i));
  });

  it('spreads any prefix evenly: no tenth of the things is missed or crowded', () => {
    const count = 13500;
    const order = spreadOrder(count);
    for (const share of [1 / 16, 1 / 8, 0.25, 0.3, 0.5, 0.77]) {
      const taken = Math.round(share * count);
      const tenths = new Array(10).fill(0);
      for (let k = 0; k < taken; k++) tenths[Math.floor((10 * order[k]) / count)]++;
      // A tier of 1/16 is spread as far as bundles of 64 go; whole tiers are even.
      const slack = 0.25 * (count / 160) + BUNDLE;
      for (const n of tenths) expect(Math.abs(n - taken / 10)).toBeLessThanOrEqual(slack);
    }
  });

  it('takes one of every 16 neighbours in each sixteenth', () => {
    const order = spreadOrder(4096);
    for (let tier = 0; tier < 16; tier++) {
      const groups = Array.from(order.subarray(256 * tier, 256 * (tier + 1)), (i) => i >> 4);
      expect(groups.sort((a, b) => a - b)).toEqual(Array.from({ length: 256 }, (_, g) => g));
    }
  });

  it('draws its first eight bundles from eight different eighths', () => {
    const order = spreadOrder(65536);
    const eighths = Array.from({ length: 8 }, (_, bundle) => Math.floor(order[bundle * BUNDLE] / 8192));
    expect(eighths.sort()).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
  });

  it('keeps the 64 things of an instance together', () => {
    const order = spreadOrder(65536);
    for (let bundle = 0; bundle < order.length; bundle += BUNDLE) {
      const part = order.subarray(bundle, bundle + BUNDLE);
      expect(Math.max(...part) - Math.min(...part)).toBeLessThan(16 * BUNDLE);
    }
  });
});
