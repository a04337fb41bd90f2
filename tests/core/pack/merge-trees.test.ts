import { describe, expect, it } from 'vitest';
import { hashPcg, hashUnit } from '../../../src/core/math/hash.ts';
import { shareOut } from '../../../src/core/pack/grove-order.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { BRANCH_LAYERS, POSE_TARGETS, TREE_LAYERS } from '../../../src/core/pack/layout.ts';
import { groveLeaf, leafTexel } from '../../../src/core/pack/leaf-texel.ts';
import { mergeTrees, type Standing } from '../../../src/core/pack/merge-trees.ts';
import type { PackedTree } from '../../../src/core/pack/packed.ts';
import { layerStart } from '../../../src/core/pack/texel-array.ts';
import { unpackBranch, unpackPiece } from '../../../src/core/pack/unpack.ts';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import type { Placement } from '../../../src/core/wind/place.ts';
import { poseTree } from '../../../src/core/wind/pose-tree.ts';
import { SpringRun } from '../../../src/core/wind/spring-run.ts';
import { swayTexels } from '../../../src/core/wind/sway.ts';
import type { Wind } from '../../../src/core/wind/wind.ts';
import { shippedWind } from '../wind/shipped-winds.ts';
import { shippedSpecies } from './shipped-species.ts';

const grown = growPacked(shippedSpecies('quaking-aspen'), 1, { quality: 0.2 }).packed;
const other = growPacked(shippedSpecies('quaking-aspen'), 2, { quality: 0.2 }).packed;
const standings: readonly Standing[] = [
  { tree: grown, x: 5, y: -3, z: 1.5, turn: 0.7 },
  { tree: other, x: -6, y: 2, z: -0.75, turn: -2.4 },
  { tree: grown, x: 0.5, y: 7, z: 0, turn: 3.9 },
];
const grove = mergeTrees(standings);

/** Number in the grove of every piece of a tree: those of each depth follow those of the trees before it. */
function numbersOf(index: number): Int32Array {
  const { tree } = standings[index]!;
  const out = new Int32Array(tree.pieceCount);
  for (let d = 0; d + 1 < tree.depthStart.length; d++) {
    let at = grove.depthStart[d]!;
    for (const { tree: before } of standings.slice(0, index)) at += before.depthStart[d + 1]! - before.depthStart[d]!;
    for (let i = tree.depthStart[d]!; i < tree.depthStart[d + 1]!; i++) out[i] = at++;
  }
  return out;
}

/** Largest distance, metres, between a tree of the grove and the tree that stands alone there, in poses of both. */
function apart(index: number, alone: Float32Array, together: Float32Array): number {
  const { tree, x, y, z, turn } = standings[index]!;
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  let most = 0;
  numbersOf(index).forEach((number, i) => {
    for (const target of Object.values(POSE_TARGETS)) {
      const a = layerStart(tree.restPose, target) + 4 * i;
      const b = layerStart(grove.restPose, target) + 4 * number;
      const [px, py, pz] = alone.subarray(a, a + 3);
      most = Math.max(most, Math.abs(c * px! - s * py! + x - together[b]!));
      most = Math.max(most, Math.abs(s * px! + c * py! + y - together[b + 1]!), Math.abs(pz! + z - together[b + 2]!));
    }
  });
  return most;
}

const poseOf = (tree: PackedTree, wind: Wind, time: number, place?: Placement, steps = 0): Float32Array => {
  const state = windStateAt(wind, time, place);
  const bends =
    wind.model === 'spring'
      ? new SpringRun(tree, (at, out) => {
          windStateAt(wind, at, place, out);
        }).bendsAt(time)
      : wind.model === 'sway'
        ? { sway: swayTexels(tree, wind.sway) }
        : {};
  let pose = poseTree(tree, state, steps > 0 ? 'lagged' : 'exact', undefined, undefined, bends);
  for (let k = 1; k < steps; k++) pose = poseTree(tree, state, 'lagged', pose, undefined, bends);
  return pose;
};

describe('a merged grove', () => {
  const gale = shippedWind('gale');
  // Its profile makes the height count: that above each tree's own foot.
  const profiled: Wind = { ...gale, profile: { ...gale.profile, kind: 'log' } as Wind['profile'] };
  it.each([
    ['direct', { ...profiled, model: 'direct' }, 3.7, 0],
    ['spring', { ...profiled, model: 'spring' }, 1.5, 0],
    ['sway', { ...profiled, model: 'sway' }, 3.7, 0],
    ['lagged', { ...profiled, model: 'direct' }, 3.7, 40],
  ] as [string, Wind, number, number][])('moves as its trees do alone at their places: %s', (_, wind, time, steps) => {
    const together = poseOf(grove, wind, time, undefined, steps);
    expect(together.some((v, i) => Math.abs(v - grove.restPose.data[i]!) > 0.1)).toBe(true);
    standings.forEach(({ tree, x, y, turn }, index) => {
      const alone = poseOf(tree, wind, time, { x, y, yaw: turn }, steps);
      expect(apart(index, alone, together)).toBeLessThan(5e-4);
    });
  });

  it('stands at rest where its trees stand, parents before children, all pieces of a depth together', () => {
    standings.forEach(({ tree }, index) => {
      expect(apart(index, tree.restPose.data, grove.restPose.data)).toBeLessThan(1e-5);
    });
    for (let d = 0; d + 1 < grove.depthStart.length; d++) {
      for (let i = grove.depthStart[d]!; i < grove.depthStart[d + 1]!; i++) {
        const { parent } = unpackPiece(grove, i);
        if (d === 0) expect(parent).toBe(-1);
        else if (!(parent >= grove.depthStart[d - 1]! && parent < grove.depthStart[d]!)) expect.fail(`piece ${i}`);
      }
    }
  });

  it('keeps every branch and leaf of every tree on its own piece, and knows its tree', () => {
    const numbers = standings.map((_, index) => numbersOf(index));
    const seen = new Set<number>();
    const joint = layerStart(grove.branches, BRANCH_LAYERS.JOINT);
    for (let place = 0; place < grove.pieceCount; place++) {
      const { piece, depth } = unpackBranch(grove, place);
      const tree = grove.branches.data[joint + 4 * place + 3]!;
      if (!numbers[tree]!.includes(piece)) expect.fail(`branch ${place}`);
      if (!(piece >= grove.depthStart[depth]! && piece < grove.depthStart[depth + 1]!)) expect.fail(`depth ${place}`);
      seen.add(piece);
    }
    expect(seen.size).toBe(grove.pieceCount);
    const mine: string[][] = standings.map(() => []);
    for (let place = 0; place < grove.leafCount; place++) {
      const { piece, tree } = groveLeaf(grove.leaves.data[4 * place]!);
      const rest = grove.leaves.data.subarray(4 * place + 1, 4 * place + 4).join();
      mine[tree]!.push(`${piece} ${grove.leaves.data[4 * place]! >>> 31} ${rest}`);
    }
    standings.forEach(({ tree }, index) => {
      const alone = Array.from({ length: tree.leafCount }, (_, place) => {
        const { piece, odd } = leafTexel(tree.leaves.data, place);
        return `${numbers[index]![piece]} ${odd ? 1 : 0} ${tree.leaves.data.subarray(4 * place + 1, 4 * place + 4).join()}`;
      });
      // In the order that they have alone: what is left out of a tree is what it would leave out by itself.
      expect(mine[index]).toEqual(alone);
    });
  });

  it('tells of each tree where it stands, how high it is and where its crown is', () => {
    const texel = (layer: number, index: number) => {
      const at = layerStart(grove.trees, layer) + 4 * index;
      return [...grove.trees.data.subarray(at, at + 4)];
    };
    const height = other.bounds[5]!;
    expect(texel(TREE_LAYERS.PLACE, 1)).toEqual([-6, 2, -0.75, height]);
    expect(texel(TREE_LAYERS.CROWN, 1)[2]).toBeCloseTo(other.crown[2]! - 0.75, 5);
    expect(texel(TREE_LAYERS.TURN, 2)[1]).toBeCloseTo(Math.sin(3.9), 6);
    expect(grove.bounds[5]).toBeCloseTo(Math.max(...standings.map(({ tree, z }) => tree.bounds[5]! + z)), 4);
  });
});

describe('the order of a grove', () => {
  it.each([
    [[30000, 20000, 100, 1]],
    [[5, 7, 3, 9, 4]],
    [Array.from({ length: 40 }, (_, i) => 500 + Math.floor(3000 * hashUnit(hashPcg(i))))],
  ])('spreads any prefix evenly over the trees %#', (counts) => {
    const all = counts.reduce((a, b) => a + b, 0);
    const taken = counts.map(() => 0);
    let place = 0;
    shareOut(counts, (tree, first, count, at) => {
      expect([first, at]).toEqual([taken[tree], place]);
      taken[tree]! += count;
      place += count;
      const share = place / all;
      // To within two of its runs, of which there are 64 in a large tree.
      counts.forEach((n, k) => {
        const slack = 2 * Math.max(1, n / 64) + 0.06 * n;
        if (Math.abs(taken[k]! - share * n) > slack) expect.fail(`tree ${k}: ${taken[k]} of ${n} at ${share}`);
      });
    });
    expect(taken).toEqual(counts);
  });
});

describe('what is no grove', () => {
  it('is told so: no tree, too many, too many pieces', () => {
    expect(() => mergeTrees([])).toThrow('at least one tree');
    const one = { tree: grown, x: 0, y: 0, z: 0, turn: 0 };
    expect(() => mergeTrees(Array.from({ length: 2049 }, () => one))).toThrow('2049 trees');
    const many = Math.ceil(2 ** 20 / grown.pieceCount);
    expect(() => mergeTrees(Array.from({ length: many + 1 }, () => one))).toThrow('1048576 pieces are allowed');
  });
});
