import { describe, expect, test } from 'vitest';
import { grow } from '../../../src/core/grow/grow.ts';
import { splitSequence, spreadAngleDeg } from '../../../src/core/grow/splits.ts';
import type { Tree } from '../../../src/core/grow/tree.ts';
import { angleDeg, axisAt, edit, mean, nodeAt, nodesOf, plain, stemsOf, trees } from './species.ts';

const trunk = (level: Parameters<typeof edit>[1]['levels'], switches = {}) =>
  edit(plain, { levels: { 0: { ...level?.[0] } }, switches });
const clonesOf = ({ stems }: Tree) => [...stems.clone.keys()].filter((i) => stems.clone[i] === 1);

describe('the counts of section 4.2', () => {
  test.each([
    [3, 1, 4],
    [5, 2, 81],
  ])('nCurveRes %i with nSegSplits %i gives %i stems', (curveRes, segSplits, stems) => {
    expect(grow(trunk({ 0: { curveRes, segSplits } }), 1).stems.count).toBe(stems);
  });
});

describe('clones', () => {
  const split = trunk({ 0: { curveRes: 4, segSplits: 1, splitAngle: 20 } });

  test('a clone starts where it leaves its twin and has its length and radius', () => {
    const tree = grow(split, 2);
    const { stems } = tree;
    for (const i of clonesOf(tree)) {
      const twin = stems.parent[i];
      expect(twin).toBeLessThan(i);
      expect(stems.parentZ[i]).toBe(stems.zStart[i]);
      expect(stems.length[i]).toBe(stems.length[twin]);
      expect(stems.baseRadius[i]).toBe(stems.baseRadius[twin]);
      expect(nodesOf(tree, i)).toBe(5 - 4 * stems.zStart[i]);
      const at = (stems.zStart[i] - stems.zStart[twin]) * 4;
      expect(nodeAt(tree, i, 0)).toEqual(nodeAt(tree, twin, at));
    }
  });

  test('row 29: fractions are diffused along the stem, as printed for the trunk', () => {
    const tree = grow(trunk({ 0: { curveRes: 21, segSplits: 0.4 } }), 1);
    const own = clonesOf(tree).filter((i) => tree.stems.parent[i] === 0);
    const ends = splitSequence(0.4, 20).flatMap((n, i) => (n ? [(i + 1) / 21] : []));
    expect(own.map((i) => tree.stems.zStart[i])).toEqual(ends.map(Math.fround));
  });

  test('row 29: on other levels stems start with an error of their own, and the mean is kept', () => {
    const species = edit(plain, { tree: { levels: 2 }, levels: { 1: { branches: 200, segSplits: 0.1, curveRes: 3 } } });
    const tree = grow(species, 1);
    const splits = clonesOf(tree).length / 200;
    expect(Math.abs(splits - 0.2)).toBeLessThan(0.05);
  });

  test('row 30: splits at the end of every segment but the last', () => {
    const places = clonesOf(grow(split, 1)).map((i) => grow(split, 1).stems.zStart[i]);
    expect(new Set(places)).toEqual(new Set([0.25, 0.5, 0.75]));
    expect(grow(trunk({ 0: { curveRes: 1, segSplits: 1 } }), 1).stems.count).toBe(1);
  });

  test('row 31: clones halve the propensity to clone only where the switch says so', () => {
    const count = (halveCloning: boolean) =>
      mean(trees(trunk({ 0: { curveRes: 6, segSplits: 1 } }, { halveCloning }), 5).map((tree) => tree.stems.count));
    expect(count(false)).toBe(32);
    expect(count(true)).toBeLessThan(12);
    expect(count(true)).toBeGreaterThan(2);
  });

  test('row 31: a stem and its clones share its children', () => {
    const species = edit(split, { tree: { levels: 2 }, levels: { 1: { branches: 200 } } });
    const counts = trees(species, 6).map((tree) => stemsOf(tree, 1).length);
    expect(Math.abs(mean(counts) - 200)).toBeLessThan(3);
  });

  test('row 32: base splits leave at the end of the first segment, spread evenly about the vertical', () => {
    const tree = grow(trunk({ 0: { baseSplits: 3, splitAngle: 30, curveRes: 5 } }), 7);
    expect(tree.stems.count).toBe(4);
    const azimuths = [0, 1, 2, 3].map((i) => {
      const [x, y] = axisAt(tree, i, i === 0 ? 1 : 0, 2);
      if (i > 0) expect(tree.stems.zStart[i]).toBe(Math.fround(0.2));
      return (Math.atan2(y, x) * 180) / Math.PI;
    });
    azimuths.slice(1).forEach((azimuth, k) => {
      const off = ((azimuth - azimuths[0] - 90 * (k + 1) + 900) % 360) - 180;
      expect(Math.abs(off)).toBeLessThanOrEqual(22.6);
    });
  });

  test('row 33: stem and clones all turn by the full angle, less the declination', () => {
    const tree = grow(trunk({ 0: { curveRes: 2, segSplits: 1, splitAngle: 25 } }), 1);
    expect(angleDeg(axisAt(tree, 0, 1, 2), [0, 0, 1])).toBeCloseTo(25, 3);
    expect(angleDeg(axisAt(tree, 1, 0, 2), [0, 0, 1])).toBeCloseTo(25, 3);
    const leaning = grow(trunk({ 0: { curveRes: 3, curve: 30, baseSplits: 0, segSplits: 0.5, splitAngle: 25 } }), 1);
    // The first split (0.5 rounds up) is at declination 0; the second trunk segment leans 25 + 10.
    expect(angleDeg(axisAt(leaning, 0, 1, 2), [0, 0, 1])).toBeCloseTo(35, 3);
  });

  test('row 34: the angle goes back over the remaining segments, on stem and clone', () => {
    const tree = grow(trunk({ 0: { curveRes: 5, baseSplits: 1, splitAngle: 40 } }), 1);
    for (const [stem, first] of [
      [0, 1],
      [1, 0],
    ]) {
      const leans = [0, 1, 2, 3].map((k) => angleDeg(axisAt(tree, stem, first + k, 2), [0, 0, 1]));
      // Four segments are left after the split: 40 / 4 at each joint between them.
      leans.forEach((lean, k) => {
        expect(lean).toBeCloseTo(40 - 10 * k, 3);
      });
    }
  });

  test('row 35: a single clone diverges by 20 degrees and more, wider near the vertical', () => {
    expect(spreadAngleDeg(90, 1, 0.75)).toBeCloseTo(42.5, 12);
    expect(spreadAngleDeg(0, 1, 0.75)).toBeCloseTo(110, 12);
    expect(spreadAngleDeg(0, 1, 1)).toBeCloseTo(140, 12);
    const angles = trees(trunk({ 0: { curveRes: 2, segSplits: 1, splitAngle: 30 } }), 300).map((tree) => {
      const azimuth = (v: number[]) => (Math.atan2(v[1], v[0]) * 180) / Math.PI;
      const turn = azimuth(axisAt(tree, 1, 0, 2)) - azimuth(axisAt(tree, 0, 1, 2));
      return ((turn + 540) % 360) - 180;
    });
    const sizes = angles.map(Math.abs);
    expect(Math.min(...sizes)).toBeGreaterThanOrEqual(19.999);
    expect(Math.max(...sizes)).toBeLessThanOrEqual(110.001);
    expect(Math.max(...sizes)).toBeGreaterThan(95);
    expect(Math.abs(mean(angles.map(Math.sign)))).toBeLessThan(0.2);
  });

  test('row 36: the stem runs straight on where its split angle is 0, the clones turn', () => {
    const leaning = trunk({ 0: { curveRes: 4, curve: 80, segSplits: 0.3 } });
    const tree = grow(leaning, 1);
    expect(clonesOf(tree).length).toBeGreaterThan(0);
    const still = grow(edit(leaning, { levels: { 0: { segSplits: 0 } } }), 1);
    for (let k = 0; k < 5; k++) expect(nodeAt(tree, 0, k)).toEqual(nodeAt(still, 0, k));
  });

  test('row 37: several clones stand at even angles', () => {
    const tree = grow(trunk({ 0: { curveRes: 2, segSplits: 3, splitAngle: 30 } }), 3);
    const azimuths = [0, 1, 2, 3].map((i) => {
      const [x, y] = axisAt(tree, i, i === 0 ? 1 : 0, 2);
      return (Math.atan2(y, x) * 180) / Math.PI;
    });
    for (let k = 1; k < 4; k++) {
      const off = ((azimuths[k] - azimuths[0] - 90 * k + 900) % 360) - 180;
      expect(Math.abs(off)).toBeLessThanOrEqual(22.6);
    }
  });
});
