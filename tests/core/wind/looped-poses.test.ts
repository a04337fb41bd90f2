import { describe, expect, it } from 'vitest';
import { bonedTree } from '../../../src/core/mesh/boned-tree.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { LoopedPoses } from '../../../src/core/wind/looped-poses.ts';
import { planeOf, poseOf } from '../../../src/core/wind/pose-plainly.ts';
import type { Wind } from '../../../src/core/wind/wind.ts';
import { SMALL } from '../mesh/small-trees.ts';
import { shippedWind, windNames } from './shipped-winds.ts';
import { GALE } from './some-winds.ts';

const grown = growPacked(SMALL.willow, 3);

/** Largest distance between the control points of two poses, metres. */
function apart(a: Float32Array, b: Float32Array): number {
  let most = 0;
  const plane = planeOf(grown.packed.restPose);
  for (let target = 0; target < 4; target++) {
    for (let i = 0; i < grown.packed.pieceCount; i++) {
      for (let k = 0; k < 3; k++) {
        const at = target * plane + 4 * i + k;
        most = Math.max(most, Math.abs(a[at] - b[at]));
      }
    }
  }
  return most;
}

const gusty: Wind = {
  ...GALE,
  gusts: [
    { start: 2, x: 0, y: 0, direction: 0.4, speed: 8, amplitude: 0.3, rise: 0.5, fall: 1.5, width: 0, repeat: 0 },
  ],
};

describe('poses of a loop', () => {
  it.each([
    ['direct', 4.3],
    ['spring', 4.3],
    ['sway', 4.3],
    ['spring', 7],
    ['sway', 8],
  ] as const)('%s, %s s: the end is the beginning, to a millimetre, and in between much moves', (model, seconds) => {
    const poses = new LoopedPoses(grown.packed, { ...gusty, model }, 1, seconds);
    const first = poses.at(0).slice();
    const middle = poses.at(seconds * 0.45).slice();
    const before = poses.at(seconds * (1 - 1e-5)).slice();
    expect(apart(before, first)).toBeLessThan(2e-3);
    expect(apart(middle, first)).toBeGreaterThan(0.05);
    expect(poses.open).toEqual([]);
  });

  it('has the wind of the time that was asked for, each wave going whole turns', () => {
    const poses = new LoopedPoses(grown.packed, { ...GALE, model: 'direct' }, 3, 5);
    expect(poses.change).toBeLessThan(0.35);
    expect(poses.change).toBeGreaterThan(0);
  });

  it.each(windNames)('closes for the wind %s', (name) => {
    const wind = shippedWind(name);
    const small = bonedTree(grown.packed, grown.pieces, 2).tree;
    const poses = new LoopedPoses(small, wind, 0, 6);
    const plane = planeOf(small.restPose);
    const at = (time: number) => {
      const pose = poses.at(time);
      return Array.from({ length: small.pieceCount }, (_, i) => poseOf(pose, plane, i).curve.p3).flat();
    };
    const [first, last] = [at(0), at(6 - 1e-7)];
    const gap = Math.max(...first.map((x, i) => Math.abs(x - last[i])));
    if (poses.open.length === 0) expect(gap).toBeLessThan(2e-3);
    expect(gap).toBeLessThan(0.05);
  });

  it('moves the lower levels alone as they move in the whole tree, to the bit', () => {
    const { tree, at } = bonedTree(grown.packed, grown.pieces, 2);
    const [whole, part] = [grown.packed, tree].map((each) => new LoopedPoses(each, gusty, 0, 4, 0));
    const [a, b] = [whole.at(1.3), part.at(1.3)];
    const [planeA, planeB] = [planeOf(grown.packed.restPose), planeOf(tree.restPose)];
    for (let i = 0; i < grown.packed.pieceCount; i++) {
      if (at[i] >= 0) expect(poseOf(b, planeB, at[i])).toEqual(poseOf(a, planeA, i));
      else expect(grown.pieces.level[i]).toBeGreaterThanOrEqual(2);
    }
  });
});
