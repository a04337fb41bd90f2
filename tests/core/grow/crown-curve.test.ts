import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { crownCurve } from '../../../src/core/grow/crown-curve.ts';
import { mainBranchLength } from '../../../src/core/grow/stem-shape.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { hashPacked } from '../../../src/core/pack/hash-packed.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import { shippedSpecies } from '../pack/shipped-species.ts';

const curves = fc.array(fc.double({ min: 0, max: 1, noNaN: true }), { minLength: 2, maxLength: 8 });

describe('the crown curve', () => {
  it('goes through its numbers, the first at the base of the crown', () => {
    fc.assert(
      fc.property(curves, (curve) => {
        for (const [i, y] of curve.entries()) expect(crownCurve(curve, i / (curve.length - 1))).toBeCloseTo(y, 12);
      }),
    );
  });

  it('never leaves the range of the two numbers that it runs between', () => {
    fc.assert(
      fc.property(curves, fc.double({ min: 0, max: 1, noNaN: true }), (curve, at) => {
        const i = Math.min(Math.floor(at * (curve.length - 1)), curve.length - 2);
        const pair = curve.slice(i, i + 2);
        const y = crownCurve(curve, at);
        expect(y).toBeGreaterThanOrEqual(Math.min(...pair) - 1e-12);
        expect(y).toBeLessThanOrEqual(Math.max(...pair) + 1e-12);
      }),
    );
  });

  it('is straight where its numbers are, and has no corner where they are not', () => {
    for (const z of [0.1, 0.45, 0.8]) expect(crownCurve([0.2, 0.4, 0.6, 0.8], z)).toBeCloseTo(0.2 + 0.6 * z, 12);
    const h = 1e-6;
    const slope = (z: number) => (crownCurve([0.1, 0.9, 0.7, 0.3], z + h) - crownCurve([0.1, 0.9, 0.7, 0.3], z)) / h;
    for (const z of [1 / 3, 2 / 3]) expect(slope(z - 2 * h)).toBeCloseTo(slope(z + h), 3);
  });

  it('takes the place of the shape for the main branches, from the base of the crown up', () => {
    // 4 m bare of 10 m: the crown's base is at 4 m.
    expect(mainBranchLength(0.5, 10, 4, 4, 7, undefined, [1, 0.25])).toBeCloseTo(5, 12);
    expect(mainBranchLength(0.5, 10, 10, 4, 7, undefined, [1, 0.25])).toBeCloseTo(1.25, 12);
    expect(mainBranchLength(0.5, 10, 7, 4, 7, undefined, [1, 0.25])).toBeCloseTo(5 * 0.625, 12);
  });

  it('shapes a tree, and one without it stays as it was', () => {
    const aspen = shippedSpecies('quaking-aspen');
    const wide = growPacked({ ...aspen, tree: { ...aspen.tree, crown: [1, 0.02] } }, 3, { leaves: false }).stems;
    const part = (low: number, high: number): number => {
      const lengths = [...wide.length].filter(
        (_, i) => wide.level[i] === 1 && wide.parentZ[i] >= low && wide.parentZ[i] < high,
      );
      return lengths.reduce((sum, l) => sum + l, 0) / lengths.length;
    };
    expect(part(0.1, 0.5)).toBeGreaterThan(2.5 * part(0.75, 1));
    const absent = growPacked({ ...aspen, tree: { ...aspen.tree } }, 3);
    expect('crown' in aspen.tree).toBe(false);
    expect(hashPacked(absent.packed)).toBe(hashPacked(growPacked(aspen, 3).packed));
  });

  it('is a list of two to eight numbers in a file', () => {
    const aspen = shippedSpecies('quaking-aspen');
    const withCrown = (crown: unknown) => parseSpecies({ ...aspen, tree: { ...aspen.tree, crown } });
    expect(withCrown([0.2, 1, 0.3]).species?.tree.crown).toEqual([0.2, 1, 0.3]);
    for (const wrong of [[1], [0, 1, 2], Array(9).fill(0.5), 0.4, null]) {
      const { faults } = withCrown(wrong);
      expect(faults?.map((f) => [f.path, f.allowed])).toEqual([['tree.crown', 'a list of 2 to 8 numbers from 0 to 1']]);
    }
  });
});
