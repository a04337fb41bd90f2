import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { GrowthBudgetError, GrowthCancelled } from '../../../src/core/grow/budget.ts';
import { grow } from '../../../src/core/grow/grow.ts';
import type { Tree } from '../../../src/core/grow/tree.ts';
import { hashPcg } from '../../../src/core/math/hash.ts';
import type { Species } from '../../../src/core/species/species.ts';
import { axisAt, edit, names, nodeAt, plain, shipped, stemsOf, trees } from './species.ts';

/** A hash of all arrays of a tree, bit for bit. */
function fingerprint({ stems, leaves }: Tree): string {
  let hash = 1;
  for (const array of [...Object.values(stems), ...Object.values(leaves)]) {
    if (typeof array === 'number') continue; // `count`
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    for (let i = 0; i + 3 < bytes.length; i += 4) {
      hash = hashPcg(hash ^ (bytes[i] | (bytes[i + 1] << 8) | (bytes[i + 2] << 16) | (bytes[i + 3] << 24)));
    }
  }
  return hash.toString(16);
}

/** The arrays of the stems: entries a stem, or a node for those of 3 and 9. */
const PER_STEM = {
  level: 1,
  parent: 1,
  parentZ: 1,
  clone: 1,
  length: 1,
  zStart: 1,
  baseRadius: 1,
  path: 1,
  nodeStart: 1,
  nodePosition: 3,
  nodeFrame: 9,
} as const;
type Numbers = Uint8Array | Int32Array | Uint32Array | Float32Array;
/** Whether two arrays are equal bit for bit; quicker than toEqual, which compares one number after the other. */
const sameBits = (a: Numbers, b: Numbers): boolean => {
  const [p, q] = [a, b].map((each) => Buffer.from(each.buffer, each.byteOffset, each.byteLength));
  return p.length > 0 && p.equals(q);
};

describe('row 50: the same seed, the same tree', () => {
  test.each([
    ['quaking-aspen', '61a22c08'],
    ['black-tupelo', '34457c26'],
    ['california-black-oak', '8ea5f684'],
  ] as const)('%s has the arrays that it had', (name, expected) => {
    // A change here changes every tree that people have made: it needs a reason in the changelog.
    expect(fingerprint(grow(shipped(name), 7))).toBe(expected);
    expect(fingerprint(grow(shipped(name), 8))).not.toBe(expected);
  });

  test('editing level 2 leaves levels 0 and 1 bit for bit', () => {
    for (const name of names) {
      const species = edit(shipped(name), { tree: { levels: 3 }, levels: { 2: { branches: 4 } } });
      const other = edit(species, {
        levels: {
          2: {
            branches: 9,
            curve: 33,
            curveV: 10,
            length: 0.3,
            lengthV: 0.1,
            segSplits: 0.5,
            rotate: 20,
            downAngle: 10,
          },
        },
      });
      const [a, b] = [species, other].map((each) => grow(each, 5, { leaves: false }).stems);
      const kept = a.level.indexOf(2);
      expect(b.level.indexOf(2)).toBe(kept);
      expect(a.count).not.toBe(b.count);
      const nodes = a.nodeStart[kept];
      for (const [key, size] of Object.entries(PER_STEM)) {
        const of = (stems: typeof a) =>
          stems[key as keyof typeof PER_STEM].subarray(0, size * (size > 1 ? nodes : kept));
        expect(sameBits(of(a), of(b)), key).toBe(true);
      }
    }
  });

  test('leaves on or off leave the skeleton alone', () => {
    const species = shipped('quaking-aspen');
    const bare = grow(species, 3, { leaves: false });
    expect(bare.leaves.count).toBe(0);
    const other = edit(species, { leaves: { count: 3, downAngle: 10, rotate: -20 } });
    for (const { stems } of [grow(species, 3), grow(other, 3)]) {
      for (const key of Object.keys(PER_STEM) as (keyof typeof PER_STEM)[]) {
        expect(sameBits(stems[key], bare.stems[key]), key).toBe(true);
      }
    }
  });

  test('a limit of levels gives the first levels of the whole tree', () => {
    const species = shipped('black-tupelo');
    const { stems } = grow(species, 3);
    const limited = grow(species, 3, { levels: 2 });
    expect(limited.leaves.count).toBe(0);
    expect(limited.stems.count).toBe(stems.level.indexOf(2));
    const { nodePosition } = limited.stems;
    expect(sameBits(nodePosition, stems.nodePosition.subarray(0, nodePosition.length))).toBe(true);
  });

  test('a child added to a stem leaves its other children what they draw', () => {
    const species = edit(plain, { tree: { levels: 2 }, levels: { 1: { lengthV: 0.2, branches: 20 } } });
    const relative = (branches: number) => {
      const tree = grow(edit(species, { levels: { 1: { branches } } }), 1);
      return stemsOf(tree, 1).map((i) => tree.stems.length[i]);
    };
    expect(relative(24).slice(0, 20)).toEqual(relative(20).slice(0, 20));
  });
});

describe('the whole tree', () => {
  test('row 17: the radius of the trunk is its length, Ratio and 0Scale, once', () => {
    const species = edit(plain, {
      tree: { levels: 2, ratio: 0.02 },
      levels: { 0: { scale: 3, length: 0.5 }, 1: { taper: 0 } },
    });
    const { stems } = grow(species, 1);
    expect(stems.baseRadius[0]).toBeCloseTo(5 * 0.02 * 3, 6);
    const expected = (i: number) =>
      Math.min(stems.baseRadius[0] * 0.3 ** 1.2, stems.baseRadius[0] * (1 - stems.parentZ[i]));
    for (let i = 1; i < stems.count; i++) expect(stems.baseRadius[i]).toBeCloseTo(Math.max(expected(i), 1e-4), 6);
  });

  test('row 18: ZScale stretches the finished tree along z', () => {
    const species = edit(shipped('california-black-oak'), { tree: { levels: 2 } });
    const [a, b] = [1, 2].map((zScale) => grow(edit(species, { tree: { zScale } }), 1, { leaves: false }));
    let worst = 0;
    for (let n = 0; n < a.stems.nodePosition.length; n++) {
      const factor = n % 3 === 2 ? 2 : 1;
      worst = Math.max(worst, Math.abs(b.stems.nodePosition[n] - factor * a.stems.nodePosition[n]));
    }
    expect(worst).toBeLessThan(1e-6);
    for (const stem of [0, 5, 20]) {
      const [p, q] = [0, 1].map((k) => nodeAt(b, stem, k));
      const along = q.map((value, k) => value - p[k]);
      const size = Math.hypot(...along);
      for (const k of [0, 1, 2]) expect(axisAt(b, stem, 0, 2)[k]).toBeCloseTo(along[k] / size, 4);
    }
    expect(b.stems.length[0]).toBeGreaterThan(1.5 * a.stems.length[0]);
  });

  test('row 19: no stem is thicker than its parent where it starts, or thinner than 0.1 mm', () => {
    const { stems } = grow(shipped('quaking-aspen'), 1);
    let faults = 0;
    for (let i = 1; i < stems.count; i++) {
      const limit = Math.max(stems.baseRadius[stems.parent[i]] * (1 - stems.parentZ[i]), 1e-4);
      if (stems.baseRadius[i] > limit + 1e-7 || stems.baseRadius[i] < 0.99999e-4) faults++;
    }
    expect(faults).toBe(0);
  });

  test('row 51: levels beyond 3 use the parameters of level 3', () => {
    const deep = edit(plain, {
      tree: { levels: 6 },
      levels: { 1: { branches: 2 }, 2: { branches: 2 }, 3: { branches: 2, curveRes: 3 } },
    });
    const { stems } = grow(deep, 1);
    expect(new Set(stems.level)).toEqual(new Set([0, 1, 2, 3, 4, 5]));
    for (let i = 0; i < stems.count; i++)
      if (stems.level[i] >= 3) expect(stems.nodeStart[i + 1] - stems.nodeStart[i]).toBe(4);
  });

  test('row 52: several trunks stand apart in a disc and lean out of it', () => {
    const shrub = edit(plain, { tree: { disc: 0.2 }, levels: { 0: { branches: 7, downAngle: 20 } } });
    const tree = grow(shrub, 1);
    expect(tree.stems.count).toBe(7);
    for (let i = 0; i < 7; i++) {
      expect(tree.stems.parent[i]).toBe(-1);
      const [x, y, z] = nodeAt(tree, i, 0);
      expect(z).toBe(0);
      expect(Math.hypot(x, y)).toBeLessThanOrEqual(2);
      const lean = axisAt(tree, i, 0, 2);
      expect((lean[0] * x + lean[1] * y) / Math.hypot(x, y)).toBeCloseTo(Math.sin((20 * Math.PI) / 180), 5);
      for (let k = 0; k < i; k++) {
        const [u, v] = nodeAt(tree, k, 0);
        expect(Math.hypot(x - u, y - v)).toBeGreaterThan(0.3);
      }
    }
  });

  test('row 53: no tree is smaller than a quarter of its Scale', () => {
    const scales = trees(edit(shipped('california-black-oak'), { tree: { levels: 1 } }), 200).map((tree) => tree.scale);
    expect(Math.min(...scales)).toBe(2.5);
    expect(Math.max(...scales)).toBeGreaterThan(19);
    expect(Math.max(...scales)).toBeLessThan(20);
  });

  test('parents stand before children, level by level', () => {
    const { stems } = grow(shipped('california-black-oak'), 4);
    let faults = 0;
    for (let i = 1; i < stems.count; i++) {
      const above = stems.parent[i] < 0 ? -1 : stems.level[stems.parent[i]];
      if (stems.parent[i] >= i || stems.level[i] < stems.level[i - 1]) faults++;
      if (stems.level[i] - (stems.clone[i] ? 0 : 1) !== above) faults++;
    }
    expect(faults).toBe(0);
  });
});

describe('changes that must show in a known way', () => {
  const scaled = (species: Species, s: number) =>
    edit(species, {
      tree: { scale: s * species.tree.scale, scaleV: s * species.tree.scaleV },
      leaves: { scale: s * species.leaves.scale },
    });

  test('a tree twice as large is the same tree, twice as large', () => {
    const arbitrary = fc.record({ name: fc.constantFrom(...names), seed: fc.nat(), power: fc.constantFrom(-1, 1, 2) });
    fc.assert(
      fc.property(arbitrary, ({ name, seed, power }) => {
        const species = edit(shipped(name), { tree: { levels: 2 } });
        const s = 2 ** power;
        const [a, b] = [species, scaled(species, s)].map((each) => grow(each, seed));
        const larger = (values: Float32Array) => values.map((value) => s * value);
        expect(sameBits(b.stems.length, larger(a.stems.length))).toBe(true);
        expect(sameBits(b.stems.nodePosition, larger(a.stems.nodePosition))).toBe(true);
        expect(sameBits(b.stems.nodeFrame, a.stems.nodeFrame)).toBe(true);
        expect(sameBits(b.leaves.orientation, a.leaves.orientation)).toBe(true);
      }),
      { numRuns: 12 },
    );
  });

  test('whatever a species says, all numbers of its tree are finite', () => {
    const level = fc.record({
      length: fc.double({ min: 0, max: 2, noNaN: true }),
      lengthV: fc.double({ min: 0, max: 1, noNaN: true }),
      taper: fc.double({ min: 0, max: 3, noNaN: true }),
      segSplits: fc.double({ min: 0, max: 1, noNaN: true }),
      splitAngle: fc.double({ min: 0, max: 360, noNaN: true }),
      curveRes: fc.integer({ min: 1, max: 6 }),
      curve: fc.double({ min: -360, max: 360, noNaN: true }),
      curveBack: fc.constantFrom(0, -90, 200),
      curveV: fc.double({ min: -90, max: 720, noNaN: true }),
      curveSideV: fc.double({ min: 0, max: 720, noNaN: true }),
      downAngle: fc.double({ min: -360, max: 360, noNaN: true }),
      downAngleV: fc.double({ min: -360, max: 360, noNaN: true }),
      rotate: fc.double({ min: -360, max: 360, noNaN: true }),
      branches: fc.double({ min: -4, max: 6, noNaN: true }),
    });
    const arbitrary = fc.record({
      levels: fc.tuple(level, level, level, level),
      tree: fc.record({
        shape: fc.integer({ min: 0, max: 9 }),
        baseSize: fc.double({ min: 0, max: 0.99, noNaN: true }),
        levels: fc.integer({ min: 1, max: 4 }),
        attractionUp: fc.double({ min: -10, max: 10, noNaN: true }),
        zScale: fc.constantFrom(1, 0.5),
      }),
      pruning: fc.record({
        ratio: fc.double({ min: 0, max: 1, noNaN: true }),
        widthPeak: fc.double({ min: 0, max: 1, noNaN: true }),
        powerLow: fc.double({ min: 0, max: 10, noNaN: true }),
      }),
      paperAttraction: fc.boolean(),
      seed: fc.nat(),
    });
    fc.assert(
      fc.property(arbitrary, ({ levels, tree, pruning, paperAttraction, seed }) => {
        const species = edit(plain, { tree, levels, pruning, switches: { paperAttraction }, leaves: { count: 3 } });
        const { stems, leaves } = grow(species, seed, { budget: { stems: 20_000 } });
        for (const array of [
          stems.nodePosition,
          stems.nodeFrame,
          stems.length,
          stems.baseRadius,
          leaves.orientation,
          leaves.z,
        ]) {
          expect(array.every(Number.isFinite)).toBe(true);
        }
        expect(stems.parentZ.every((z) => z >= 0 && z <= 1)).toBe(true);
      }),
      { numRuns: 60 },
    );
  });
});

describe('budget, progress and cancelling', () => {
  const fault = (species: Species, budget = {}): GrowthBudgetError => {
    try {
      grow(species, 1, { budget });
    } catch (error) {
      if (error instanceof GrowthBudgetError) return error;
      throw error;
    }
    throw new Error('the species grew');
  };

  test('a billion stems asked for at one level', () => {
    const error = fault(edit(plain, { tree: { levels: 2 }, levels: { 1: { branches: 1e9 } } }));
    expect(error).toMatchObject({
      what: 'stems',
      path: 'levels[1].branches',
      count: 1,
      asked: 1e9 + 1,
      limit: 400_000,
    });
    expect(error.message).toContain('levels[1].branches');
    expect(error.message).toContain('1\u2009000\u2009000\u2009001');
  });

  test('a billion stems over three levels', () => {
    const thousand = { branches: 1000 };
    const error = fault(edit(plain, { tree: { levels: 4 }, levels: { 1: thousand, 2: thousand, 3: thousand } }));
    expect(error).toMatchObject({ what: 'stems', path: 'levels[2].branches', count: 1001 });
  });

  test('clones without end', () => {
    const error = fault(edit(plain, { levels: { 0: { curveRes: 100, segSplits: 4 } } }));
    expect(error).toMatchObject({ path: 'levels[0].segSplits' });
  });

  test('leaves', () => {
    expect(fault(edit(shipped('quaking-aspen'), { leaves: { count: 10_000 } }))).toMatchObject({
      what: 'leaves',
      path: 'leaves.count',
    });
    expect(fault(edit(shipped('quaking-aspen'), { leaves: { count: -10_000 } }))).toMatchObject({ what: 'leaves' });
  });

  test('memory', () => {
    expect(fault(edit(plain, { levels: { 0: { curveRes: 1e9 } } }))).toMatchObject({
      what: 'bytes',
      path: 'levels[0].curveRes',
    });
    expect(fault(shipped('quaking-aspen'), { bytes: 100_000 })).toMatchObject({ what: 'bytes' });
  });

  test('a limit that is just enough is enough', () => {
    const species = shipped('quaking-aspen');
    const { stems } = grow(species, 1);
    expect(grow(species, 1, { budget: { stems: stems.count + 2 } }).stems.count).toBe(stems.count);
    expect(() => grow(species, 1, { budget: { stems: stems.count - 2 } })).toThrow(GrowthBudgetError);
  });

  test('progress rises to 1 and tells counts', () => {
    const told: [number, number][] = [];
    const tree = grow(shipped('black-tupelo'), 1, { onProgress: (done, { stems }) => told.push([done, stems]) });
    expect(told.length).toBeGreaterThan(10);
    expect(told.at(-1)).toEqual([1, tree.stems.count]);
    for (let i = 1; i < told.length; i++) expect(told[i][0]).toBeGreaterThanOrEqual(told[i - 1][0]);
  });

  test('growing stops when it is asked to', () => {
    let asked = 0;
    expect(() => grow(shipped('black-tupelo'), 1, { shouldCancel: () => ++asked > 3 })).toThrow(GrowthCancelled);
    expect(asked).toBe(4);
  });
});
