import { describe, expect, test } from 'vitest';
import { newFrame, turnX, turnZ } from '../../../src/core/grow/frame.ts';
import { grow } from '../../../src/core/grow/grow.ts';
import { leafBend } from '../../../src/core/grow/leaf-bend.ts';
import type { Tree } from '../../../src/core/grow/tree.ts';
import { type Quaternion, rotateByQuaternion } from '../../../src/core/math/quaternion.ts';
import type { Vec3 } from '../../../src/core/math/vec3.ts';
import { angleDeg, axisAt, edit, plain, stemsOf } from './species.ts';

const leafy = edit(plain, {
  tree: { levels: 2 },
  leaves: { count: 40, bend: 0, scale: 0.2, downAngle: 50, downAngleV: 0, rotate: 90, rotateV: 0 },
});
const axisOf = ({ leaves }: Tree, leaf: number, axis: Vec3): Vec3 =>
  rotateByQuaternion([...leaves.orientation.subarray(4 * leaf, 4 * leaf + 4)] as Quaternion, axis);
const leavesOn = (tree: Tree, stem: number) => [...tree.leaves.stem.keys()].filter((i) => tree.leaves.stem[i] === stem);

test('row 40: leaves per stem follow ShapeRatio 4 of the place of their stem, times quality', () => {
  const tree = grow(leafy, 1);
  for (const i of stemsOf(tree, 1)) {
    const expected = 40 * (0.5 + 0.5 * tree.stems.parentZ[i]);
    expect(Math.abs(leavesOn(tree, i).length - expected)).toBeLessThanOrEqual(1);
  }
  expect(Math.abs(grow(leafy, 1, { quality: 3 }).leaves.count / tree.leaves.count - 3)).toBeLessThan(0.05);
});

test('row 41: quality makes leaves smaller so that they cover as much', () => {
  expect(grow(leafy, 1).leaves.length[0]).toBeCloseTo(0.2, 6);
  expect(grow(edit(leafy, { leaves: { quality: 4 } }), 1).leaves.length[0]).toBeCloseTo(0.1, 6);
  expect(grow(leafy, 1, { quality: 4 }).leaves.length[0]).toBeCloseTo(0.1, 6);
});

describe('row 42: the angles of leaves', () => {
  const angles = (species: typeof leafy) => {
    const tree = grow(species, 1);
    return [...tree.leaves.stem].map((stem, i) => angleDeg(axisOf(tree, i, [0, 0, 1]), axisAt(tree, stem, 0, 2)));
  };
  const own = { downAngle: undefined, downAngleV: undefined, rotate: undefined, rotateV: undefined };

  test('are those of level Levels', () => {
    for (const angle of angles(edit(leafy, { leaves: own, levels: { 2: { downAngle: 33 } } })))
      expect(angle).toBeCloseTo(33, 2);
  });
  test('are those of level 3 where Levels is beyond', () => {
    const deep = edit(leafy, {
      tree: { levels: 4 },
      leaves: own,
      levels: { 1: { branches: 2 }, 3: { downAngle: 71 } },
    });
    for (const angle of angles(deep)) expect(angle).toBeCloseTo(71, 2);
  });
  test('are their own where the species says so', () => {
    for (const angle of angles(leafy)) expect(angle).toBeCloseTo(50, 2);
  });
});

test('row 43: a negative Leaves is a fan at the tip, nRotate wide', () => {
  const tree = grow(edit(leafy, { leaves: { count: -5, downAngle: 0, rotate: 100 } }), 1);
  for (const stem of stemsOf(tree, 1)) {
    const fan = leavesOn(tree, stem);
    expect(fan).toHaveLength(5);
    for (const [k, leaf] of fan.entries()) {
      expect(tree.leaves.z[leaf]).toBe(1);
      expect(angleDeg(axisOf(tree, leaf, [0, 0, 1]), axisOf(tree, fan[0], [0, 0, 1]))).toBeCloseTo(25 * k, 2);
    }
    expect(angleDeg(axisOf(tree, fan[2], [0, 0, 1]), axisAt(tree, stem, 0, 2))).toBeCloseTo(0, 2);
  }
});

describe('row 44: leaves turn to the light', () => {
  const tilted = () => {
    const f = newFrame();
    turnZ(f, 2);
    turnX(f, 1.9);
    turnZ(f, -0.4);
    return f;
  };
  test('a bend of 1 makes the normal vertical', () => {
    const f = tilted();
    leafBend(f, 1, 2, 1);
    expect(f[5]).toBeCloseTo(1, 12);
  });
  test('a bend of b leaves 1 - b of both angles', () => {
    const f = tilted();
    const declination = Math.acos(f[5]);
    const azimuth = Math.atan2(f[4], f[3]);
    leafBend(f, 1, 2, 0.3);
    expect(Math.acos(f[5])).toBeCloseTo(0.7 * declination, 12);
    const target = Math.atan2(2, 1);
    const wrapped = ((target - azimuth + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
    expect(Math.cos(Math.atan2(f[4], f[3]) - azimuth - 0.3 * wrapped)).toBeCloseTo(1, 12);
  });
  test('leaves of a grown tree look up and out more than without it', () => {
    const up = (bend: number) => {
      const tree = grow(edit(leafy, { leaves: { bend } }), 1);
      return (
        [...tree.leaves.stem.keys()].reduce((sum, i) => sum + axisOf(tree, i, [0, 1, 0])[2], 0) / tree.leaves.count
      );
    };
    expect(up(0.5)).toBeGreaterThan(up(0) + 0.2);
    expect(up(1)).toBeCloseTo(1, 5);
  });
});

describe('a flat spray', () => {
  // The trunk leans, so that no plane of a twig is level.
  const leaning = edit(leafy, { levels: { 0: { downAngle: 40 } }, leaves: { rotate: 137.5 } });
  const flat = (part: number) => grow(edit(leaning, { leaves: { flat: part } }), 1);

  test('of 1 lays all leaves into the plane of their twig and its parent, in two rows, with the upper face up', () => {
    const tree = flat(1);
    for (const stem of stemsOf(tree, 1)) {
      const [x, y, z] = [0, 1, 2].map((axis) => axisAt(tree, stem, 0, axis)) as [Vec3, Vec3, Vec3];
      const rows = leavesOn(tree, stem).map((leaf) => {
        const [along, normal] = [axisOf(tree, leaf, [0, 0, 1]), axisOf(tree, leaf, [0, 1, 0])];
        expect(Math.abs(angleDeg(along, x) - 90)).toBeLessThan(0.01);
        expect(angleDeg(along, z)).toBeCloseTo(50, 2);
        expect(Math.min(angleDeg(normal, x), 180 - angleDeg(normal, x))).toBeLessThan(0.1);
        expect(normal[2]).toBeGreaterThanOrEqual(-1e-6);
        return angleDeg(along, y) < 90;
      });
      expect(rows).toEqual(rows.map((_, k) => rows[k % 2]));
      expect(new Set(rows).size).toBe(2);
    }
  });
  test('of 0 is what the species was without it', () => {
    expect(flat(0).leaves.orientation).toEqual(grow(leaning, 1).leaves.orientation);
  });
});

test('a bare trunk bears leaves above its bare part', () => {
  const tree = grow(edit(leafy, { tree: { levels: 1, baseSize: 0.5 } }), 1);
  expect(tree.leaves.count).toBe(20);
  expect(Math.min(...tree.leaves.z)).toBeGreaterThanOrEqual(0.5);
});

test('orientations are unit quaternions and phases spread over a turn', () => {
  const { leaves } = grow(leafy, 1);
  for (let i = 0; i < leaves.count; i++)
    expect(Math.hypot(...leaves.orientation.subarray(4 * i, 4 * i + 4))).toBeCloseTo(1, 6);
  expect(Math.min(...leaves.phase)).toBeGreaterThanOrEqual(0);
  expect(Math.max(...leaves.phase)).toBeLessThan(1);
  expect(Math.max(...leaves.phase) - Math.min(...leaves.phase)).toBeGreaterThan(0.9);
});
