import { describe, expect, test } from 'vitest';
import { MECHANICS, SWAY_LAYERS } from '../../../src/core/pack/layout.ts';
import { layerStart } from '../../../src/core/pack/texel-array.ts';
import {
  swayClock,
  swayParts,
  swayPhase,
  swayRate,
  swayReach,
  swayStir,
  swaySwing,
  swayTexels,
  swayUniform,
} from '../../../src/core/wind/sway.ts';
import { STILL } from '../../../src/core/wind/wind.ts';
import { bentTree } from './bent-tree.ts';

const tree = bentTree(60, 9);
const { sway } = STILL;
const texels = swayTexels(tree, sway);
const texel = (layer: number, i: number): Float32Array => {
  const at = layerStart(texels, layer) + 4 * i;
  return texels.data.subarray(at, at + 4);
};

describe('phase', () => {
  test('is exact after months: whole turns alone are dropped', () => {
    const k = 655;
    const hour = 3600;
    for (const time of [0.25, 1000.5, 4096 + 0.25, 4096 * 6000 + 77.125]) {
      const turns = (k / 4096) * time;
      const phase = swayPhase(k, swayClock(time));
      const off = phase - turns - Math.round(phase - turns);
      expect(Math.abs(off)).toBeLessThan(1e-6);
    }
    expect(swayPhase(k, swayClock(4096 * hour))).toBe(0);
    expect([...swayClock(-0.75)]).toEqual([4095, 0.25]);
  });

  test('runs on without a jump where the clock turns over', () => {
    for (const k of [1, 655, 11469]) {
      const [a, b] = [4095.999, 4096.001].map((time) => swayPhase(k, swayClock(time)));
      const off = b - a - Math.round(b - a);
      expect(Math.abs(off - (k / 4096) * 0.002)).toBeLessThan(2e-4);
    }
  });
});

describe('the swing of a tree', () => {
  test('has the amplitude, frequency and slower sine of the paper', () => {
    const [gain, offset] = [texel(SWAY_LAYERS.GAIN, 0), texel(SWAY_LAYERS.OFFSET, 0)];
    // 4.5 m long and 0.09 m thick, of which this piece is a part.
    const share = gain[1] / ((swayReach(4.5, 0.09, 0) * Math.PI) / 180);
    expect(share).toBeCloseTo(tree.mechanics[MECHANICS.Z1] - tree.mechanics[MECHANICS.Z0], 5);
    expect(gain[0] / gain[1]).toBeCloseTo(0.5, 6);
    expect(gain[2] / 4096).toBeCloseTo(swayRate(sway, 0.09, 4.5) / (2 * Math.PI), 3);
    expect(gain[3]).toBe(Math.round(0.7 * gain[2]));
    const parts = swayUniform(sway, 1);
    const [quick, slow] = swayParts(sway.speed, sway.gust);
    const time = 12.3;
    const b = 2 * Math.PI * (offset[0] + (gain[2] / 4096) * time);
    const expected = quick * Math.sin(b) + slow * Math.sin(2 * Math.PI * (0.7 * offset[0] + (gain[3] / 4096) * time));
    expect(swaySwing(gain, offset, parts, swayClock(time))[0]).toBeCloseTo(expected, 5);
  });

  test('stems do not swing in unison, the pieces of one stem do', () => {
    const next = tree.plan.findIndex((p) => p.next);
    expect(texel(SWAY_LAYERS.OFFSET, next)).toEqual(texel(SWAY_LAYERS.OFFSET, tree.plan[next].parent));
    const offsets = tree.plan.flatMap((p, i) => (p.next ? [] : [texel(SWAY_LAYERS.OFFSET, i)[0]]));
    expect(new Set(offsets).size).toBe(offsets.length);
    expect(texel(SWAY_LAYERS.OFFSET, 0)[0]).not.toBe(texel(SWAY_LAYERS.OFFSET, 0)[1]);
  });

  test('thin stems swing faster by length than the trunk where they are read as cantilevers', () => {
    const cantilever = { ...sway, reading: 'cantilever' as const };
    const ratio = (length: number) =>
      swayRate(cantilever, 0.02 * length, length) / swayRate(sway, 0.02 * length, length);
    expect(ratio(0.5)).toBeCloseTo(2, 9);
    expect(ratio(4)).toBeCloseTo(0.25, 9);
  });

  test('no wind, no sway', () => {
    const parts = swayUniform(sway, 0);
    expect(swaySwing(texel(SWAY_LAYERS.GAIN, 0), texel(SWAY_LAYERS.OFFSET, 0), parts, swayClock(3))).toEqual([0, 0]);
    expect(swayStir([0, 0], parts)).toBe(0);
    expect(swayStir([0.14, 0], swayUniform(sway, 1))).toBeGreaterThan(0.05);
  });
});
