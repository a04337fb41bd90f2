import { describe, expect, it } from 'vitest';
import { handlesOf, sectionFrame } from '../../../src/core/math/frames.ts';
import type { Quaternion } from '../../../src/core/math/quaternion.ts';
import { rotateByQuaternion } from '../../../src/core/math/quaternion.ts';
import { distance, transform, type Vec3 } from '../../../src/core/math/vec3.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { hashPacked } from '../../../src/core/pack/hash-packed.ts';
import { leafTexel } from '../../../src/core/pack/leaf-texel.ts';
import { expectJoints, expectOrder } from '../pieces/invariants.ts';
import { curveOf, restError } from '../pieces/pose-at-rest.ts';
import { SHIPPED, shippedSpecies } from './shipped-species.ts';

/** Seed 1 of each species, on every machine and in every browser. A change here changes the trees in every saved link. */
const HASHES = {
  'quaking-aspen': 'a67ad0c8',
  'black-tupelo': 'e4d0a95b',
  'weeping-willow': '468e6e55',
  'california-black-oak': 'd8892d5b',
} as const;

describe.each(SHIPPED)('%s', (name) => {
  const { tree, pieces, attachments, packed, stats } = growPacked(shippedSpecies(name), 1);

  it('is followed within 1 % of the length by its trunk, and 2 % by all other stems', () => {
    expect(pieces.deviation[0]).toBeLessThanOrEqual(0.01);
    for (const deviation of pieces.deviation) expect(deviation).toBeLessThanOrEqual(0.02);
  });

  it('rests as it was grown, to float precision', () => {
    // Largest error that was seen: 6e-7 of the tree's size and 6e-5 of the orientation (oak).
    const { position, orient } = restError(pieces);
    expect(position).toBeLessThan(3e-6 * stats.height);
    expect(orient).toBeLessThan(2e-4);
  });

  it('keeps every stem in its grown direction and length', () => {
    const { stems } = tree;
    let turned = 0;
    let stretched = 0;
    for (let s = 0; s < stems.count; s++) {
      const p = pieces.firstOfStem[s];
      const { p0, p1 } = curveOf(pieces, p);
      const node = 9 * stems.nodeStart[s];
      const edge = distance(p0, p1);
      const z = [0, 1, 2].map((k) => p0[k] + edge * stems.nodeFrame[node + 6 + k]) as Vec3;
      // Control points are rounded to float32: half a thousandth of a millimetre at 20 m.
      turned = Math.max(turned, distance(p1, z) / stats.height);
      let arc = 0;
      for (let q = p; q >= 0; q = pieces.next[q]) arc += pieces.arc[q];
      const grown = stems.length[s] * (1 - stems.zStart[s]);
      stretched = Math.max(stretched, Math.abs(arc / grown - 1));
    }
    expect(turned).toBeLessThan(1e-6);
    // A smooth curve cuts the corners of the polyline.
    expect(stretched).toBeLessThan(0.1);
  });

  it('sorts its pieces by depth, then parent, and joins them smoothly', () => {
    expectOrder(pieces, tree);
    expectJoints(pieces);
  });

  it('keeps leaves in their grown orientation, on the piece that covers their place', () => {
    const { leaves } = tree;
    let turned = 0;
    let beside = 0;
    for (let i = 0; i < leaves.count; i += 7) {
      const p = attachments.piece[i];
      const inside = leaves.z[i] >= pieces.span[2 * p] - 1e-6 && leaves.z[i] <= pieces.span[2 * p + 1] + 1e-6;
      if (pieces.stem[p] !== leaves.stem[i] || !inside) beside++;
      const curve = curveOf(pieces, p);
      const o = Array.from(pieces.orient.subarray(3 * p, 3 * p + 3)) as Vec3;
      const frame = sectionFrame(curve, handlesOf(curve, o), attachments.v[i]);
      const local = Array.from(attachments.orientation.subarray(4 * i, 4 * i + 4)) as Quaternion;
      const grown = Array.from(leaves.orientation.subarray(4 * i, 4 * i + 4)) as Quaternion;
      for (const axis of [
        [1, 0, 0],
        [0, 1, 0],
      ] as Vec3[]) {
        const error = distance(transform(frame, rotateByQuaternion(local, axis)), rotateByQuaternion(grown, axis));
        // On a twig of millimetres the rounding of the rest pose alone turns the frame.
        turned = Math.max(turned, error - 4e-6 / pieces.arc[p]);
      }
    }
    expect(beside).toBe(0);
    expect(turned).toBeLessThan(1e-5);
  });

  it('spreads the first tenth of its leaves over the whole crown', () => {
    const [cx, cy, cz, rx, ry, rz] = packed.crown;
    const { data, width, height } = packed.leaves;
    expect(data.length).toBe(width * height * 4);
    const octants = (count: number): number[] => {
      const shares = new Array(8).fill(0);
      for (let k = 0; k < count; k++) {
        const { p0 } = curveOf(pieces, leafTexel(data, k).piece);
        shares[(p0[0] > cx ? 1 : 0) + (p0[1] > cy ? 2 : 0) + (p0[2] > cz ? 4 : 0)] += 1 / count;
      }
      return shares;
    };
    expect(Math.min(rx, ry, rz)).toBeGreaterThan(0.5);
    const all = octants(packed.leafCount);
    octants(Math.round(packed.leafCount / 10)).forEach((share, k) => {
      expect(Math.abs(share - all[k])).toBeLessThan(0.05);
    });
  });

  it('is the same tree for the same seed', () => {
    expect(hashPacked(packed)).toBe(HASHES[name]);
    expect(hashPacked(growPacked(shippedSpecies(name), 2, { levels: 2 }).packed)).not.toBe(HASHES[name]);
  });
});
