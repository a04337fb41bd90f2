import { describe, expect, test } from 'vitest';
import { grow } from '../../../src/core/grow/grow.ts';
import { angleDeg, axisAt, edit, nodeAt, plain, stemsOf } from './species.ts';

const UP = [0, 0, 1];
const attracted = (attractionUp: number, level2 = {}, paperAttraction = false) =>
  edit(plain, {
    tree: { levels: 3, attractionUp },
    levels: { 2: { curveRes: 8, ...level2 } },
    switches: { paperAttraction },
  });
/** Declinations of the first and the last segment of every level-2 stem. */
const declinations = (species: ReturnType<typeof attracted>) => {
  const tree = grow(species, 1);
  return stemsOf(tree, 2).map((i) => [angleDeg(axisAt(tree, i, 0, 2), UP), angleDeg(axisAt(tree, i, 7, 2), UP)]);
};

test('switches: "paper" takes the printed form of every switch', () => {
  const stems = (switches: object) =>
    grow(edit(attracted(0.8, { segSplits: 0.6, splitAngle: 20 }), { tree: { baseSize: 0.4 }, switches }), 1).stems;
  const printed = stems({ paper: true });
  expect(printed).toEqual(stems({ halveCloning: true, paperAttraction: true }));
  expect(printed.nodePosition).not.toEqual(stems({ halveCloning: true }).nodePosition);
  expect(printed.nodePosition).not.toEqual(stems({ paperAttraction: true }).nodePosition);
  expect(stems({ paper: true, branchesAboveBase: true })).toEqual(printed);
});

describe('row 38: vertical attraction', () => {
  test.each([{}, { curve: 60, curveV: 100 }])('1 ends every stem upright, with %o', (level2) => {
    for (const [first, last] of declinations(attracted(1, level2))) {
      expect(first).toBeGreaterThan(10);
      expect(last).toBeLessThan(0.01);
    }
  });

  test('0.5 leans stems towards the vertical, 0 leaves them', () => {
    for (const [first, last] of declinations(attracted(0.5))) expect(last).toBeLessThan(0.5 * first);
    for (const [first, last] of declinations(attracted(0))) expect(last).toBeCloseTo(first, 3);
  });

  test('-3 makes every stem hang straight down and stay so', () => {
    for (const [, last] of declinations(attracted(-3))) expect(last).toBeGreaterThan(179.9);
  });

  test('10 snakes about the vertical and does not spin', () => {
    const tree = grow(attracted(10), 1);
    for (const i of stemsOf(tree, 2)) {
      const leans = Array.from({ length: 8 }, (_, k) => angleDeg(axisAt(tree, i, k, 2), UP));
      for (let k = 1; k < 8; k++) expect(leans[k]).toBeLessThanOrEqual(leans[k - 1] + 0.01);
    }
  });

  test('level 1 does not feel it', () => {
    const [a, b] = [attracted(1), attracted(0)].map((species) => grow(species, 1));
    for (const i of stemsOf(a, 1)) expect(nodeAt(a, i, 4)).toEqual(nodeAt(b, i, 4));
  });

  test('the printed form is another tree, and weaker', () => {
    const printed = declinations(attracted(1, {}, true));
    const chosen = declinations(attracted(1));
    const lean = (list: number[][]) => list.reduce((sum, [, last]) => sum + last, 0);
    expect(lean(printed)).toBeGreaterThan(lean(chosen) + 10);
  });
});

test('row 39: negative attraction bends even stems that start exactly upright', () => {
  const upright = edit(plain, {
    tree: { levels: 3, attractionUp: -4 },
    levels: { 1: { downAngle: 0 }, 2: { downAngle: 0, curveRes: 12 } },
  });
  const tree = grow(upright, 1);
  const ends = stemsOf(tree, 2).map((i) => {
    expect(angleDeg(axisAt(tree, i, 0, 2), UP)).toBeLessThan(0.01);
    const [x, y] = axisAt(tree, i, 11, 2);
    expect(angleDeg(axisAt(tree, i, 11, 2), UP)).toBeGreaterThan(5);
    return Math.atan2(y, x);
  });
  // Each falls its own way.
  expect(Math.max(...ends) - Math.min(...ends)).toBeGreaterThan(3);
});
