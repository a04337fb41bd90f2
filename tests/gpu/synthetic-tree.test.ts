import { expect, test } from 'vitest';
import { BRANCH_LAYERS, PIECE_LAYERS } from '../../src/core/pack/layout.ts';
import { leafTexel } from '../../src/core/pack/leaf-texel.ts';
import { layerStart } from '../../src/core/pack/texel-array.ts';
import { createWindState } from '../../src/core/wind/fade.ts';
import { poseTreePlainly } from '../../src/core/wind/pose-plainly.ts';
import { syntheticTree } from '../../src/gpu/crosscheck/synthetic-tree.ts';

const tree = syntheticTree(700, 5);

test('pieces are sorted by depth and parents stand one depth above, in order', () => {
  expect(tree.depthStart[0]).toBe(0);
  expect(tree.depthStart.at(-1)).toBe(700);
  expect(tree.depthStart.length).toBe(6);
  const attach = layerStart(tree.pieces, PIECE_LAYERS.ATTACH);
  let last = -1;
  for (let depth = 0; depth < 5; depth++) {
    expect(tree.depthStart[depth + 1]).toBeGreaterThan(tree.depthStart[depth]);
    for (let i = tree.depthStart[depth]; i < tree.depthStart[depth + 1]; i++) {
      const parent = tree.pieces.data[attach + 4 * i];
      if (depth === 0) expect(parent).toBe(-1);
      else {
        expect(parent).toBeGreaterThanOrEqual(tree.depthStart[depth - 1]);
        expect(parent).toBeLessThan(tree.depthStart[depth]);
        expect(parent).toBeGreaterThanOrEqual(last);
        last = parent;
      }
    }
  }
});

test('still air gives back the rest pose bit for bit, and the tree stands up', () => {
  const posed = poseTreePlainly(tree, createWindState(), 'exact');
  expect(posed).toEqual(tree.restPose.data);
  expect(tree.bounds[5] - tree.bounds[2]).toBeGreaterThan(4);
  expect(posed.every(Number.isFinite)).toBe(true);
});

test('branches and leaves name pieces that exist, with the parity of their depth', () => {
  const span = layerStart(tree.branches, BRANCH_LAYERS.SPAN);
  const stem = layerStart(tree.branches, BRANCH_LAYERS.STEM);
  for (let i = 0; i < tree.pieceCount; i++) {
    const piece = tree.branches.data[span + 4 * i];
    const depth = tree.branches.data[stem + 4 * i + 2];
    expect(piece).toBeGreaterThanOrEqual(tree.depthStart[depth]);
    expect(piece).toBeLessThan(tree.depthStart[depth + 1]);
  }
  expect(tree.leafCount).toBe(700 - tree.depthStart[4]);
  for (let i = 0; i < tree.leafCount; i++) {
    const { piece, odd } = leafTexel(tree.leaves.data, i);
    expect(piece).toBeGreaterThanOrEqual(tree.depthStart[4]);
    expect(odd).toBe(false); // depth 4 is even
  }
});

test('the same arguments give the same tree, another seed another', () => {
  expect(syntheticTree(300, 4, 9).restPose.data).toEqual(syntheticTree(300, 4, 9).restPose.data);
  expect(syntheticTree(300, 4, 9).restPose.data).not.toEqual(syntheticTree(300, 4, 8).restPose.data);
});
