import { describe, expect, it } from 'vitest';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { hashPacked } from '../../../src/core/pack/hash-packed.ts';
import { stemBuffers } from '../../../src/core/pack/stem-table.ts';
import type { Species } from '../../../src/core/species/species.ts';
import { shippedSpecies } from './shipped-species.ts';

const aspen = shippedSpecies('quaking-aspen');
const grown = growPacked(aspen, 3);
const { stems, tree, pieces, packed } = grown;
const all = Array.from({ length: stems.count }, (_, i) => i);

/** The aspen with its angles as they are written: nothing random, nothing that changes along the trunk. */
const exact = (edit: Partial<Species['levels'][number]>): Species => ({
  ...aspen,
  tree: { ...aspen.tree, levels: 2, attractionUp: 0 },
  levels: aspen.levels.map((level) => ({ ...level, curveV: 0, curve: 0, curveBack: 0, downAngleV: 0, ...edit })),
  pruning: { ...aspen.pruning, ratio: 0 },
});

describe('the table of stems', () => {
  it('numbers the stems of each level from 1 on, as many as there are', () => {
    expect([...stems.countOfLevel]).toEqual(grown.stats.levels.map((l) => l.stems + l.clones));
    for (const [level, count] of stems.countOfLevel.entries()) {
      const numbers = all.filter((i) => stems.level[i] === level).map((i) => stems.numberInLevel[i]);
      expect(numbers).toEqual(Array.from({ length: count }, (_, k) => k + 1));
    }
  });

  it('finds the stem of every piece, and its first one', () => {
    expect(stems.stemOfPiece).toHaveLength(packed.pieceCount);
    for (const i of all) expect(stems.stemOfPiece[stems.firstPiece[i]]).toBe(i);
  });

  it('says where each stem begins and ends, at rest', () => {
    for (const i of all) {
      const last = pieces.stem.lastIndexOf(i);
      expect(stems.base.subarray(3 * i, 3 * i + 3)).toEqual(
        pieces.control.subarray(12 * stems.firstPiece[i]).slice(0, 3),
      );
      expect(stems.tip.subarray(3 * i, 3 * i + 3)).toEqual(pieces.control.subarray(12 * last + 9, 12 * last + 12));
    }
    expect(Math.hypot(...stems.base.slice(0, 3))).toBe(0);
  });

  it('measures the down angle that the species asks for, and the lean of the trunk', () => {
    const { stems: few } = growPacked(exact({ downAngle: 57, segSplits: 0 }), 3, { leaves: false });
    expect(few.downAngle[0]).toBeCloseTo(57, 3);
    expect(few.count).toBeGreaterThan(10);
    for (let i = 1; i < few.count; i++) expect(few.downAngle[i]).toBeCloseTo(57, 3);
  });

  it('measures a clone against its twin before the split', () => {
    const splitting = exact({ splitAngle: 25, splitAngleV: 0, baseSplits: 0, segSplits: 0, downAngle: 0 });
    const [trunk, ...others] = splitting.levels;
    const { stems: few } = growPacked(
      { ...splitting, tree: { ...splitting.tree, levels: 1 }, levels: [{ ...trunk, baseSplits: 1 }, ...others] },
      3,
    );
    expect([...few.clone]).toEqual([0, 1]);
    expect([...few.parent]).toEqual([-1, 0]);
    expect([...few.numberInLevel]).toEqual([1, 2]);
    expect(few.length[1]).toBe(few.length[0]);
    expect(few.downAngle[1]).toBeCloseTo(25, 3);
  });

  it('knows a stem again by its path when something beside it changed', () => {
    const [trunk, limbs, ...others] = aspen.levels;
    const again = growPacked({ ...aspen, levels: [trunk, { ...limbs, downAngle: 20 }, ...others] }, 3);
    const limb = all.find((i) => stems.level[i] === 1 && stems.numberInLevel[i] === 5) as number;
    const found = again.stems.path.indexOf(stems.path[limb]);
    expect(again.stems.numberInLevel[found]).toBe(5);
    expect(again.stems.downAngle[found]).not.toBeCloseTo(stems.downAngle[limb], 1);
  });

  it('is handed over whole, and leaves the hash of the tree alone', () => {
    expect(new Set(stemBuffers(stems)).size).toBe(Object.keys(stems).length - 1);
    expect(hashPacked(packed)).toBe(hashPacked(growPacked(aspen, 3).packed));
    expect(tree.stems.path).toBe(stems.path);
  });
});
