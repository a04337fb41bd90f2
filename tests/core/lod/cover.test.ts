import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { coverCount } from '../../../src/core/look/leaf-count.ts';
import { expandLeaves, type LeafTriangles } from '../../../src/core/mesh/expand-leaves.ts';
import { placeLeaves } from '../../../src/core/mesh/leaf-placements.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import { coverage, type Frame, silhouette } from './coverage.ts';

/** Length in pixels of the blades that are drawn when leaves begin to be left out (LEAST_BLADE of src/view/detail.ts). */
const BLADE = 4;

test.each(['quaking-aspen', 'california-black-oak', 'black-spruce'])(
  'any first part of the leaves of %s, down to a tenth, covers what all of them do, within 5 percent',
  (name) => {
    const { species } = parseSpecies(readFileSync(`public/species/${name}.json`, 'utf8'));
    if (!species) throw new Error(name);
    const grown = growPacked(species, 1);
    const { packed } = grown;
    expect(coverCount(packed.leafCount, species.foliage)).toBeGreaterThan(10_000);
    const { bounds } = packed;
    const frame: Frame = [bounds[0]! - 1, bounds[2]! - 1, bounds[3]! + 1, bounds[5]! + 1];
    const leaves = (share: number): LeafTriangles => {
      const placed = placeLeaves(grown, { grain: 'far', most: Number.POSITIVE_INFINITY, share, levels: 9 });
      if (!placed) throw new Error(`no leaves of ${share}`);
      return expandLeaves(placed);
    };
    const all = leaves(1);
    for (const share of [0.5, 0.25, 0.1]) {
      // The size on screen at which so many are drawn: those that remain, grown, are as long as ever.
      const scale = (BLADE * Math.sqrt(share)) / (packed.leafLength * species.foliage.size);
      const whole = coverage(silhouette(all, frame, scale));
      const part = coverage(silhouette(leaves(share), frame, scale));
      expect(whole).toBeGreaterThan(400);
      expect(Math.abs(part / whole - 1), `${share} of ${name} covers ${part} pixels for ${whole}`).toBeLessThan(0.05);
    }
  },
);
