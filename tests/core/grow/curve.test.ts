import { describe, expect, test } from 'vitest';
import { curveDeltas, stemPolyline } from '../../../src/core/grow/curve.ts';
import { grow } from '../../../src/core/grow/grow.ts';
import { angleDeg, axisAt, downAngleOf, edit, nodeAt, nodesOf, plain, shipped, stemsOf } from './species.ts';

/** Turns between neighbouring segments of the trunk, in degrees. */
const turns = (changes: Parameters<typeof edit>[1], seed = 1): number[] => {
  const tree = grow(edit(plain, changes), seed);
  return Array.from({ length: nodesOf(tree, 0) - 2 }, (_, k) =>
    angleDeg(axisAt(tree, 0, k, 2), axisAt(tree, 0, k + 1, 2)),
  );
};
const sum = (values: readonly number[]) => values.reduce((a, b) => a + b, 0);

describe('row 25: the first segment does not turn, though it has its share of nCurve', () => {
  test('a trunk starts upright and turns by nCurve/nCurveRes at every joint', () => {
    const tree = grow(edit(plain, { levels: { 0: { curve: 80 } } }), 1);
    expect(axisAt(tree, 0, 0, 2)).toEqual([0, 0, 1]);
    for (const turn of turns({ levels: { 0: { curve: 80 } } })) expect(turn).toBeCloseTo(20, 3);
  });

  test('a child leaves its parent at exactly its down angle, whatever its curve', () => {
    const tree = grow(
      edit(plain, { tree: { levels: 2 }, levels: { 1: { curve: 170, curveV: 90, downAngle: 37 } } }),
      1,
    );
    for (const i of stemsOf(tree, 1)) expect(downAngleOf(tree, i)).toBeCloseTo(37, 3);
  });
});

test('row 26: nCurveBack has its exact share, an odd nCurveRes splits its middle segment', () => {
  const deltas = curveDeltas(40, 80, 3);
  expect(deltas).toEqual([40 / 1.5, (0.5 * 40) / 1.5 + (0.5 * 80) / 1.5, 80 / 1.5]);
  expect(sum(deltas)).toBeCloseTo(120, 12);
  expect(curveDeltas(40, 0, 4)).toEqual([10, 10, 10, 10]);
  const grown = turns({ levels: { 0: { curve: 40, curveBack: 80, curveRes: 3 } } });
  expect(grown[0]).toBeCloseTo(deltas[1], 3);
  expect(grown[1]).toBeCloseTo(deltas[2], 3);
});

test('a grown trunk follows stemPolyline', () => {
  const tree = grow(edit(plain, { levels: { 0: { curve: -60, curveBack: 90, curveRes: 5 } } }), 4);
  const deltas = curveDeltas(-60, 90, 5).map((degrees, i) => (i === 0 ? 0 : (degrees * Math.PI) / 180));
  const nodes = stemPolyline(10, deltas);
  const [yx, yy] = axisAt(tree, 0, 0, 1);
  for (let k = 0; k < nodes.length; k++) {
    const [x, y, z] = nodeAt(tree, 0, k);
    expect(x * yx + y * yy).toBeCloseTo(nodes[k][1], 4);
    expect(x * yy - y * yx).toBeCloseTo(0, 4);
    expect(z).toBeCloseTo(nodes[k][2], 4);
  }
});

describe('row 27: nCurveV turns about x, nCurveSideV about y', () => {
  const bent = (key: 'curveV' | 'curveSideV') => {
    const tree = grow(edit(plain, { levels: { 0: { [key]: 200, curveRes: 20 } } }), 1);
    return [0, 1].map((axis) => angleDeg(axisAt(tree, 0, 0, axis), axisAt(tree, 0, 20, axis)));
  };
  test('the x axis stays under nCurveV alone', () => {
    expect(bent('curveV')[0]).toBeLessThan(0.01);
    expect(bent('curveV')[1]).toBeGreaterThan(1);
  });
  test('the y axis stays under nCurveSideV alone', () => {
    expect(bent('curveSideV')[0]).toBeGreaterThan(1);
    expect(bent('curveSideV')[1]).toBeLessThan(0.01);
  });
  test('no turn exceeds nCurveV/nCurveRes', () => {
    const all = turns({ levels: { 0: { curveV: 200, curveRes: 100 } } });
    expect(Math.max(...all)).toBeLessThanOrEqual(2.001);
    expect(Math.max(...all)).toBeGreaterThan(1.8);
  });
});

describe('row 28: a negative nCurveV makes a helix', () => {
  const helix = edit(plain, { levels: { 0: { curveV: -30, curve: 70, curveRes: 6 } } });

  test('every step leans from the axis by exactly |nCurveV|', () => {
    const tree = grow(helix, 3);
    for (let k = 0; k < nodesOf(tree, 0) - 1; k++) {
      const [ax, ay, az] = nodeAt(tree, 0, k);
      const [bx, by, bz] = nodeAt(tree, 0, k + 1);
      expect(angleDeg([bx - ax, by - ay, bz - az], [0, 0, 1])).toBeCloseTo(30, 3);
    }
    expect(nodeAt(tree, 0, nodesOf(tree, 0) - 1)[2]).toBeCloseTo(10 * Math.cos(Math.PI / 6), 4);
  });

  test('it winds half a turn a segment, or as many as helixTurns says', () => {
    const azimuths = (turnsASegment: number) => {
      const tree = grow(edit(helix, { levels: { 0: { helixTurns: turnsASegment } } }), 3);
      const steps = (nodesOf(tree, 0) - 1) / 6;
      return [0, 1].map((segment) => {
        const [x, y] = axisAt(tree, 0, segment * steps, 2);
        return Math.atan2(y, x) / (2 * Math.PI);
      });
    };
    const [a, b] = azimuths(0.5);
    expect((((b - a) % 1) + 1) % 1).toBeCloseTo(0.5, 4);
    const [c, d] = azimuths(0.25);
    expect((((d - c) % 1) + 1) % 1).toBeCloseTo(0.25, 4);
  });

  test('its frame does not spin about the stem', () => {
    const tree = grow(helix, 3);
    for (let k = 1; k < nodesOf(tree, 0); k++) {
      expect(angleDeg(axisAt(tree, 0, k, 1), axisAt(tree, 0, 0, 1))).toBeLessThan(61);
    }
  });

  test('its phase is random for each stem', () => {
    const [a, b] = [1, 2].map((seed) => axisAt(grow(helix, seed), 0, 0, 2));
    expect(angleDeg(a, b)).toBeGreaterThan(1);
  });
});

test('frames are rotations at every node of every species', () => {
  const { stems } = grow(shipped('california-black-oak'), 2);
  const f = stems.nodeFrame;
  let worst = 0;
  for (let n = 0; n < f.length; n += 9) {
    for (let a = 0; a < 9; a += 3) {
      for (let b = 0; b < 9; b += 3) {
        const dot = f[n + a] * f[n + b] + f[n + a + 1] * f[n + b + 1] + f[n + a + 2] * f[n + b + 2];
        worst = Math.max(worst, Math.abs(dot - (a === b ? 1 : 0)));
      }
    }
  }
  expect(worst).toBeLessThan(1e-6);
});
