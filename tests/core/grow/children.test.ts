import { describe, expect, test } from 'vitest';
import { grow } from '../../../src/core/grow/grow.ts';
import { mainBranchLength } from '../../../src/core/grow/stem-shape.ts';
import {
  angleDeg,
  axisAt,
  downAngleOf,
  edit,
  mean,
  nodeAt,
  plain,
  shipped,
  stemsOf,
  trees,
  withoutVariation,
} from './species.ts';

const two = edit(plain, { tree: { levels: 2 } });
const three = edit(plain, { tree: { levels: 3 } });

describe('counts and means that follow from the formulas (weber-penn.md, section 3)', () => {
  test('aspen', () => {
    const species = withoutVariation(shipped('quaking-aspen'));
    const grown = trees(species, 12);
    for (const tree of grown) expect(stemsOf(tree, 1)).toHaveLength(30);
    const { stems } = grown[0];
    const trunk = stems.length[0];
    const level1 = grown.flatMap((tree) =>
      stemsOf(tree, 1).map((i) => [tree.stems.length[i], tree.stems.baseRadius[i]]),
    );
    expect(mean(level1.map(([length]) => length)) / trunk).toBeCloseTo(0.225, 3);
    expect(mean(level1.map(([, radius]) => radius)) / stems.baseRadius[0]).toBeCloseTo(0.1552, 3);
    const downs = grown.flatMap((tree) => stemsOf(tree, 1).map((i) => downAngleOf(tree, i)));
    expect(Math.abs(mean(downs) - 70)).toBeLessThan(0.3);
    const level2 = grown.flatMap((tree) => stemsOf(tree, 2).map((i) => tree.stems.length[i]));
    expect(level2.length / level1.length).toBeCloseTo(24, 1);
    expect(mean(level2) / trunk).toBeCloseTo(0.0971, 3);
    expect(Math.abs(mean(grown.map((tree) => tree.leaves.count / stemsOf(tree, 2).length)) - 18.75)).toBeLessThan(0.05);
  });

  test('tupelo', () => {
    const grown = trees(withoutVariation(shipped('black-tupelo')), 6);
    const count = (level: number) => mean(grown.map((tree) => stemsOf(tree, level).length));
    expect(count(1)).toBe(40);
    expect(Math.abs(count(2) / count(1) - 20)).toBeLessThan(0.1);
    expect(Math.abs(count(3) / count(2) - 9)).toBeLessThan(0.05);
    expect(Math.abs(mean(grown.map((tree) => tree.leaves.count)) / count(3) - 4.5)).toBeLessThan(0.05);
    expect(
      Math.abs(mean(grown.flatMap((tree) => stemsOf(tree, 1).map((i) => downAngleOf(tree, i)))) - 68),
    ).toBeLessThan(0.3);
  });
});

describe('lengths', () => {
  test('row 1: no branch below BaseSize of the trunk', () => {
    const tree = grow(edit(two, { tree: { baseSize: 0.6 } }), 1);
    const places = stemsOf(tree, 1).map((i) => tree.stems.parentZ[i]);
    expect(Math.min(...places)).toBeGreaterThanOrEqual(0.6);
    expect(Math.max(...places)).toBeGreaterThan(0.9);
  });

  test('row 2: a level-1 length is trunk, relative length and ShapeRatio of the height in the crown', () => {
    const tree = grow(edit(two, { tree: { baseSize: 0.4, shape: 7 } }), 3);
    for (const i of stemsOf(tree, 1)) {
      const offset = 10 * tree.stems.parentZ[i];
      expect(tree.stems.length[i]).toBeCloseTo(mainBranchLength(0.3, 10, offset, 4, 7), 5);
    }
  });

  test('row 3: deeper lengths fall with 0.6 of the offset', () => {
    const { stems } = grow(three, 1);
    for (let i = 0; i < stems.count; i++) {
      if (stems.level[i] !== 2) continue;
      const parent = stems.length[stems.parent[i]];
      expect(stems.length[i]).toBeCloseTo(0.5 * parent * (1 - 0.6 * stems.parentZ[i]), 5);
    }
  });

  test('row 4: the variation of the length is drawn for each child', () => {
    const tree = grow(edit(two, { levels: { 1: { lengthV: 0.1 } } }), 1);
    const lengths = stemsOf(tree, 1).map((i) => tree.stems.length[i] / 10);
    expect(new Set(lengths).size).toBe(lengths.length);
    expect(Math.min(...lengths)).toBeGreaterThanOrEqual(0.2);
    expect(Math.max(...lengths)).toBeLessThanOrEqual(0.4);
  });

  test('row 10: shape 9 is the bare ratio, shape 0 never below a fifth', () => {
    const shortest = (shape: number) => {
      const tree = grow(edit(two, { tree: { shape }, levels: { 1: { branches: 400 } } }), 1);
      return Math.min(...stemsOf(tree, 1).map((i) => tree.stems.length[i]));
    };
    expect(shortest(0)).toBeGreaterThan(0.59);
    expect(shortest(9)).toBeLessThan(0.02);
  });

  test('row 11: stems below 1e-4 of the tree are not made', () => {
    const few = grow(edit(two, { tree: { shape: 9 }, levels: { 1: { branches: 20_000, length: 0.001 } } }), 1);
    const shortest = Math.min(...stemsOf(few, 1).map((i) => few.stems.length[i]));
    expect(shortest).toBeGreaterThanOrEqual(1e-3 * 0.999);
    expect(stemsOf(few, 1).length).toBeLessThan(19_000);
  });
});

describe('counts', () => {
  test('row 5: 1Branches counts over the whole trunk, or all of them grow above the bare part', () => {
    const bare = edit(two, { tree: { baseSize: 0.4 }, levels: { 1: { branches: 50 } } });
    expect(stemsOf(grow(bare, 1), 1)).toHaveLength(30);
    expect(stemsOf(grow(edit(bare, { switches: { branchesAboveBase: true } }), 1), 1)).toHaveLength(50);
  });

  test('row 6: a level-1 stem bears by its length beside the longest', () => {
    const species = edit(three, { tree: { shape: 6 }, levels: { 1: { branches: 5 }, 2: { branches: 1000 } } });
    const { stems } = grow(species, 1);
    for (let i = 1; i <= 5; i++) {
      const born = stems.parent.filter((p, k) => p === i && stems.level[k] === 2).length;
      expect(Math.abs(born - 1000 * (0.2 + 0.8 * (stems.length[i] / 10 / 0.3)))).toBeLessThanOrEqual(1);
    }
  });

  test('row 7: a deeper stem bears by its place on its parent', () => {
    const species = edit(plain, {
      tree: { levels: 4 },
      levels: { 1: { branches: 2 }, 2: { branches: 6 }, 3: { branches: 400 } },
    });
    const tree = grow(species, 1);
    for (const i of stemsOf(tree, 2)) {
      const born = tree.stems.parent.filter((p) => p === i).length;
      expect(Math.abs(born - 400 * (1 - 0.5 * tree.stems.parentZ[i]))).toBeLessThanOrEqual(1);
    }
  });

  test('row 8: fractions of children even out over the seeds, and every stem gets one of the two neighbours', () => {
    const counts = trees(edit(two, { levels: { 1: { branches: 2.3 } } }), 400).map((tree) => stemsOf(tree, 1).length);
    expect(new Set(counts)).toEqual(new Set([2, 3]));
    expect(Math.abs(mean(counts) - 2.3)).toBeLessThan(0.07);
  });

  test('row 9: children stand evenly, jittered by at most a quarter of their distance', () => {
    const tree = grow(two, 5);
    const places = stemsOf(tree, 1).map((i) => tree.stems.parentZ[i]);
    const gaps = places.slice(1).map((z, k) => 20 * (z - places[k]));
    expect(Math.min(...gaps)).toBeGreaterThanOrEqual(0.49);
    expect(Math.max(...gaps)).toBeLessThanOrEqual(1.51);
    expect(new Set(gaps.map((gap) => gap.toFixed(3))).size).toBeGreaterThan(10);
  });

  test("row 9: no child inside the parent's wood", () => {
    const thick = edit(three, { tree: { ratio: 0.08 }, levels: { 0: { taper: 0 }, 2: { branches: 100 } } });
    const tree = grow(thick, 2);
    const nearest = Math.min(
      ...stemsOf(tree, 2).map((i) => tree.stems.parentZ[i] * tree.stems.length[tree.stems.parent[i]]),
    );
    expect(nearest).toBeGreaterThanOrEqual(0.8 * 0.999);
  });
});

describe('angles', () => {
  test('row 12 and 13: a negative nDownAngleV opens the base, closes the top and draws nothing', () => {
    const species = edit(two, {
      tree: { baseSize: 0.4 },
      levels: { 1: { downAngle: 60, downAngleV: -50, branches: 200 } },
    });
    const tree = grow(species, 1);
    for (const i of stemsOf(tree, 1)) {
      const up = (tree.stems.parentZ[i] - 0.4) / 0.6;
      expect(downAngleOf(tree, i)).toBeCloseTo(110 - 80 * up, 1);
    }
    // Deeper parents have no bare part: their base has the full angle (row 13).
    const deeper = grow(edit(three, { tree: { baseSize: 0.4 }, levels: { 2: { downAngle: 60, downAngleV: -50 } } }), 1);
    for (const i of stemsOf(deeper, 2))
      expect(downAngleOf(deeper, i)).toBeCloseTo(110 - 80 * deeper.stems.parentZ[i], 1);
  });

  test('a positive nDownAngleV draws the down angle of each child, nRotateV its turn', () => {
    const species = edit(two, {
      levels: { 1: { downAngle: 60, downAngleV: 20, rotate: 0, rotateV: 30, branches: 300 } },
    });
    const tree = grow(species, 1);
    const downs = stemsOf(tree, 1).map((i) => downAngleOf(tree, i));
    expect(Math.min(...downs)).toBeGreaterThanOrEqual(39.99);
    expect(Math.min(...downs)).toBeLessThan(42);
    expect(Math.max(...downs)).toBeGreaterThan(78);
    expect(Math.max(...downs)).toBeLessThanOrEqual(80.01);
    const azimuths = stemsOf(tree, 1).map((i) => {
      const [x, y] = axisAt(tree, i, 0, 2);
      return (Math.atan2(y, x) * 180) / Math.PI;
    });
    const turns = azimuths.slice(1).map((azimuth, k) => Math.abs(((azimuth - azimuths[k] + 540) % 360) - 180));
    expect(Math.max(...turns)).toBeLessThanOrEqual(30.01);
    expect(Math.max(...turns)).toBeGreaterThan(28);
  });

  test('row 14: a spiral turns by nRotate from child to child and starts anywhere', () => {
    const azimuths = (seed: number) => {
      const tree = grow(two, seed);
      return stemsOf(tree, 1).map((i) => {
        const [x, y] = axisAt(tree, i, 0, 2);
        return (Math.atan2(y, x) * 180) / Math.PI;
      });
    };
    const first = azimuths(1);
    first.slice(1).forEach((a, k) => {
      expect((((a - first[k] - 140) % 360) + 540) % 360).toBeCloseTo(180, 2);
    });
    expect(Math.abs(first[0] - azimuths(2)[0])).toBeGreaterThan(1);
  });

  test('row 15: a negative nRotate stands children on alternate sides of the parent, measured from its y', () => {
    const species = edit(three, { levels: { 1: { branches: 1 }, 2: { rotate: -120, downAngle: 90, branches: 8 } } });
    const tree = grow(species, 1);
    const sides = stemsOf(tree, 2).map((i) => {
      const z = axisAt(tree, i, 0, 2);
      // 180 - 120 = 60 degrees from the parent's y, on either side.
      expect(angleDeg(z, axisAt(tree, tree.stems.parent[i], 0, 1))).toBeCloseTo(60, 2);
      return angleDeg(z, axisAt(tree, tree.stems.parent[i], 0, 0)) < 90;
    });
    for (let k = 1; k < sides.length; k++) expect(sides[k]).toBe(!sides[k - 1]);
  });

  test('row 16: the y axis of a child points back along its parent', () => {
    const tree = grow(three, 1);
    for (const i of stemsOf(tree, 2)) {
      const parent = axisAt(tree, tree.stems.parent[i], 0, 2);
      expect(angleDeg(axisAt(tree, i, 0, 1), parent)).toBeCloseTo(45, 2);
      expect(angleDeg(axisAt(tree, i, 0, 0), parent)).toBeCloseTo(90, 2);
    }
  });

  test('row 43: a negative nBranches is a fan at the tip', () => {
    const tree = grow(edit(two, { levels: { 1: { branches: -5, rotate: 80, downAngle: 0 } } }), 1);
    const fan = stemsOf(tree, 1);
    expect(fan).toHaveLength(5);
    for (const i of fan) expect(nodeAt(tree, i, 0)).toEqual(nodeAt(tree, 0, 4));
    const angles = fan.map((i) => angleDeg(axisAt(tree, i, 0, 2), axisAt(tree, fan[0], 0, 2)));
    for (let k = 0; k < angles.length; k++) expect(angles[k]).toBeCloseTo(20 * k, 2);
  });
});
