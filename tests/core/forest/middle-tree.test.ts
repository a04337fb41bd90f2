import { describe, expect, test } from 'vitest';
import { clumpsOf } from '../../../src/core/forest/clumps.ts';
import { middleTree } from '../../../src/core/forest/middle-tree.ts';
import { bezierPoint } from '../../../src/core/math/bezier.ts';
import { handlesOf, sectionFrame } from '../../../src/core/math/frames.ts';
import { add, transform, type Vec3 } from '../../../src/core/math/vec3.ts';
import { cardTexel, writeCard } from '../../../src/core/pack/card-texel.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { MECHANICS, MECHANICS_SIZE } from '../../../src/core/pack/layout.ts';
import type { PackedTree } from '../../../src/core/pack/packed.ts';
import { unpackBranch, unpackPiece, unpackPose } from '../../../src/core/pack/unpack.ts';
import { WindFader } from '../../../src/core/wind/fade.ts';
import { poseTree } from '../../../src/core/wind/pose-tree.ts';
import { DEFAULT_WAVE, STILL } from '../../../src/core/wind/wind.ts';
import { shippedSpecies } from '../pack/shipped-species.ts';

const species = shippedSpecies('california-black-oak');
const { packed } = growPacked(species, 5);
const middle = middleTree(packed, species);

/** Index in the full tree of each piece of the middle one: those of levels 0 and 1, in order. */
const kept = Array.from({ length: packed.pieceCount }, (_, i) => i).filter(
  (i) => packed.mechanics[MECHANICS_SIZE * i + MECHANICS.LEVEL]! < 2,
);

const depthOf = ({ depthStart }: PackedTree, piece: number): number =>
  depthStart.findIndex((start, d) => piece >= start && piece < (depthStart[d + 1] ?? 0));

describe('middle tree', () => {
  test('has the stems of levels 0 and 1 at rest as the full tree has them', () => {
    expect(middle.pieceCount).toBe(kept.length);
    expect(middle.depthStart[middle.depthStart.length - 1]).toBe(kept.length);
    expect(middle.levels).toEqual(packed.levels.slice(0, 2));
    kept.forEach((full, i) => {
      expect(unpackPose(middle.restPose, i)).toEqual(unpackPose(packed.restPose, full));
      const { parent, ...rest } = unpackPiece(middle, i);
      const { parent: old, ...same } = unpackPiece(packed, full);
      expect(rest).toEqual(same);
      expect(parent).toBe(old < 0 ? -1 : kept.indexOf(old));
    });
    for (let k = 0; k < middle.levels[1]!.start + middle.levels[1]!.count; k++) {
      const { piece, ...rest } = unpackBranch(middle, k);
      const { piece: old, ...same } = unpackBranch(packed, k);
      expect([kept[piece], rest]).toEqual([old, same]);
      expect(depthOf(middle, piece)).toBe(rest.depth);
    }
  });

  test('moves in the wind as they do', () => {
    const state = new WindFader({ ...STILL, waves: [{ ...DEFAULT_WAVE, amplitude: 0.5 }] }).at(7, undefined);
    const wind = { ...state, model: 'direct', from: null } as Parameters<typeof poseTree>[1];
    const plane = 4 * packed.restPose.width * packed.restPose.height;
    const own = 4 * middle.restPose.width * middle.restPose.height;
    const all = poseTree(packed, wind, 'exact');
    const few = poseTree(middle, wind, 'exact');
    let moved = 0;
    kept.forEach((full, i) => {
      for (let k = 0; k < 16; k++) {
        const at = Math.floor(k / 4);
        expect(few[at * own + 4 * i + (k % 4)]).toBe(all[at * plane + 4 * full + (k % 4)]);
        moved = Math.max(
          moved,
          Math.abs(few[at * own + 4 * i + (k % 4)]! - middle.restPose.data[at * own + 4 * i + (k % 4)]!),
        );
      }
    });
    expect(moved).toBeGreaterThan(0.01);
  });

  test('has a card where each clump is, on the stem that carries it', () => {
    const clumps = clumpsOf(packed);
    expect(middle.leafCount).toBe(clumps.count);
    for (let c = 0; c < clumps.count; c++) {
      const card = cardTexel(middle.leaves.data, c);
      expect(card.odd).toBe(depthOf(middle, card.piece) % 2 === 1);
      const { points, orient } = unpackPose(middle.restPose, card.piece);
      const curve = { p0: points[0], p1: points[1], p2: points[2], p3: points[3] };
      const frame = sectionFrame(curve, handlesOf(curve, orient), card.v);
      const middleOf = add(bezierPoint(curve, card.v), transform(frame, card.offset as Vec3));
      middleOf.forEach((x, k) => {
        expect(Math.abs(x - clumps.centre[3 * c + k]!)).toBeLessThan(0.01);
      });
      expect(card.radius).toBeGreaterThan(clumps.radius[c]!);
    }
  });

  test('uses each of the four pictures for a quarter of its cards', () => {
    const uses = [0, 0, 0, 0];
    for (let c = 0; c < middle.leafCount; c++) uses[cardTexel(middle.leaves.data, c).picture]!++;
    for (const n of uses) expect(Math.abs(n - middle.leafCount / 4)).toBeLessThan(2);
  });

  test.each([0, 1, 2, 3])('a card with picture %i keeps what was written', (picture) => {
    const data = new Uint32Array(8);
    const card = {
      piece: 123_456,
      odd: true,
      v: 0.25,
      phase: 0.75,
      offset: [1.5, -0.25, 3] as Vec3,
      radius: 0.8125,
      picture,
    };
    writeCard(data, 1, card);
    const read = cardTexel(data, 1);
    expect(read).toMatchObject({ piece: 123_456, odd: true, offset: card.offset, picture });
    expect(read.radius).toBeCloseTo(card.radius, 2);
    expect(read.v).toBeCloseTo(card.v, 4);
    expect(read.phase).toBeCloseTo(card.phase, 4);
  });
});
