import { describe, expect, test } from 'vitest';
import { grow } from '../../../src/core/grow/grow.ts';
import { type Envelope, fittingPart, insideEnvelope } from '../../../src/core/grow/pruning.ts';
import { envelopeRatio } from '../../../src/core/grow/stem-shape.ts';
import type { Tree } from '../../../src/core/grow/tree.ts';
import { edit, nodeAt, nodesOf, plain, shipped, stemsOf } from './species.ts';

const envelope: Envelope = {
  scale: 10,
  baseSize: 0.2,
  width: 0.4,
  widthPeak: 0.6,
  powerLow: 0.5,
  powerHigh: 0.5,
  pruneBase: false,
};
const wide = edit(plain, {
  tree: { levels: 2, baseSize: 0.2 },
  levels: { 1: { length: 0.6, branches: 60 } },
  pruning: { ratio: 1, width: 0.4, widthPeak: 0.6 },
});
const tips = (tree: Tree, level: number) => stemsOf(tree, level).map((i) => nodeAt(tree, i, nodesOf(tree, i) - 1));

test('row 45: the distance from the axis is horizontal', () => {
  // At seven tenths of the height the axis is inside, though it is 7 m from the root.
  expect(insideEnvelope(0, 0, 7, envelope)).toBe(true);
});

test('row 46: the envelope is continuous at its peak', () => {
  for (const widthPeak of [0.3, 0.6, 0.8]) {
    const shape = { widthPeak, powerLow: 0.5, powerHigh: 2 };
    expect(envelopeRatio(1 - widthPeak - 1e-12, shape)).toBeCloseTo(1, 9);
    expect(envelopeRatio(1 - widthPeak + 1e-12, shape)).toBeCloseTo(1, 9);
  }
});

test('row 47: PruneWidth is a radius', () => {
  const peak = 10 * (0.2 + 0.8 * 0.6);
  expect(insideEnvelope(3.99, 0, peak, envelope)).toBe(true);
  expect(insideEnvelope(4.01, 0, peak, envelope)).toBe(false);
});

describe('row 48: stems that hang below the crown', () => {
  const hanging = edit(plain, {
    tree: { levels: 2, baseSize: 0.3 },
    levels: { 1: { length: 0.8, downAngle: 175, branches: 40 } },
    pruning: { ratio: 1, width: 0.5 },
  });
  const lowest = (pruneBase: boolean) =>
    Math.min(...tips(grow(edit(hanging, { switches: { pruneBase } }), 1), 1).map(([, , z]) => z));
  test('are not cut', () => expect(lowest(false)).toBeLessThan(0));
  test('are cut at the base where pruneBase is set', () => {
    expect(lowest(true)).toBeGreaterThanOrEqual(3);
    expect(lowest(true)).toBeLessThan(3.2);
  });
});

describe('row 49: fitting', () => {
  test('finds the length to half a per cent', () => {
    const nodes = new Float32Array([0, 0, 6.8, 3, 0, 6.8, 8, 0, 6.8]);
    const part = fittingPart(nodes, 0, 3, envelope);
    expect(part).toBeLessThanOrEqual(0.5);
    expect(part).toBeGreaterThan(0.495);
  });

  test('every pruned stem fits, is as straight as before, and those that fitted keep their length', () => {
    const free = grow(edit(wide, { pruning: { ratio: 0 } }), 1);
    const tree = grow(wide, 1);
    const shape = { ...envelope, powerLow: 0.5, powerHigh: 0.5 };
    let shortened = 0;
    for (const [k, i] of stemsOf(tree, 1).entries()) {
      const [x, y, z] = nodeAt(tree, i, 4);
      expect(insideEnvelope(x, y, z - 1e-5, shape)).toBe(true);
      const before = free.stems.length[stemsOf(free, 1)[k]];
      expect(tree.stems.length[i]).toBeLessThanOrEqual(before);
      if (tree.stems.length[i] < before) shortened++;
    }
    expect(shortened).toBeGreaterThan(20);
  });

  test('PruneRatio blends the lengths', () => {
    const sum = (ratio: number) =>
      grow(edit(wide, { pruning: { ratio } }), 1)
        .stems.length.subarray(1)
        .reduce((a, b) => a + b, 0);
    expect(sum(0.5)).toBeCloseTo((sum(0) + sum(1)) / 2, 3);
  });

  test('the trunk is never pruned', () => {
    expect(grow(edit(wide, { pruning: { width: 0 } }), 1).stems.length[0]).toBe(10);
  });

  test('stems of which nothing is left are not made and leave no nodes', () => {
    const none = edit(wide, { pruning: { width: 0 } });
    const { stems } = grow(none, 1);
    expect(stems.count).toBe(1);
    expect(stems.nodePosition).toHaveLength(3 * 5);
    // Below the envelope's peak this one is a point: branches there are lost, those above grow.
    const some = grow(edit(wide, { pruning: { powerLow: 10, widthPeak: 0.9 } }), 1).stems;
    expect(some.count).toBeLessThan(grow(wide, 1).stems.count);
    for (let i = 1; i < some.count; i++) {
      const at = 3 * some.nodeStart[i];
      const z = some.nodePosition[at + 2];
      expect(z).toBeCloseTo(10 * some.parentZ[i], 4);
      expect(some.nodeStart[i + 1] - some.nodeStart[i]).toBe(5);
    }
    expect(some.nodePosition).toHaveLength(3 * some.nodeStart[some.count]);
  });

  test('clones are tested too', () => {
    const split = edit(wide, { levels: { 1: { segSplits: 1, splitAngle: 150, curveRes: 3 } } });
    const { stems } = grow(split, 1);
    for (let i = 1; i < stems.count; i++) {
      for (let n = stems.nodeStart[i]; n < stems.nodeStart[i + 1]; n++) {
        const [x, y, z] = stems.nodePosition.subarray(3 * n, 3 * n + 3);
        if (z >= 2.001) expect(insideEnvelope(0.999 * x, 0.999 * y, z - 1e-4, envelope)).toBe(true);
      }
    }
  });
});

test('row 20: the radius comes from the pruned length', () => {
  const { stems } = grow(wide, 1);
  for (let i = 1; i < stems.count; i++) {
    const limit = stems.baseRadius[0] * (1 - stems.parentZ[i]);
    const expected = Math.max(Math.min(stems.baseRadius[0] * (stems.length[i] / 10) ** 1.2, limit), 1e-4);
    expect(stems.baseRadius[i] / expected).toBeCloseTo(1, 4);
  }
});

test('a pruned willow keeps to its envelope above the base of its crown', () => {
  const tree = grow(shipped('weeping-willow'), 2, { levels: 3 });
  const { stems, scale } = tree;
  let beyond = 0;
  for (let i = 0; i < stems.count; i++) {
    if (stems.level[i] === 0) continue;
    const last = stems.nodeStart[i + 1] - 1;
    const [x, y, z] = stems.nodePosition.subarray(3 * last, 3 * last + 3);
    if (Math.hypot(x, y) > 0.4 * scale * 1.0001 || z < 0.05 * scale - 1e-3) beyond++;
  }
  expect(beyond).toBe(0);
});
