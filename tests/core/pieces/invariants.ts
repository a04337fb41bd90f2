import { expect } from 'vitest';
import type { Tree } from '../../../src/core/grow/tree.ts';
import { handlesOf } from '../../../src/core/math/frames.ts';
import { distance, type Vec3 } from '../../../src/core/math/vec3.ts';
import type { Pieces } from '../../../src/core/pieces/pieces.ts';
import { attachPiece } from '../../../src/core/wind/pose.ts';
import { curveOf, restOf } from './pose-at-rest.ts';

/** Parents before children, one depth up, sorted by parent within a depth; chains cover their stems without a gap. */
export function expectOrder(pieces: Pieces, tree: Tree): void {
  const { count, depth, depthStart, maxDepth, parent, span, stem, next, firstOfStem } = pieces;
  let wrong = 0;
  for (let i = 0; i < count; i++) {
    const d = depth[i];
    if (!(depthStart[d] <= i && i < depthStart[d + 1])) wrong++;
    if (parent[i] < 0 ? d !== 0 : parent[i] >= i || depth[parent[i]] !== d - 1) wrong++;
    if (i > depthStart[d] && parent[i] < parent[i - 1]) wrong++;
    // Children of one piece keep the order of the stems.
    if (i > depthStart[d] && parent[i] === parent[i - 1] && stem[i] <= stem[i - 1]) wrong++;
    if (pieces.level[i] !== tree.stems.level[stem[i]]) wrong++;
  }
  expect(wrong).toBe(0);
  expect(depthStart.length).toBe(maxDepth + 2);
  expect(depthStart[maxDepth + 1]).toBe(count);
  let seen = 0;
  for (let s = 0; s < tree.stems.count; s++) {
    let at = tree.stems.zStart[s];
    for (let p = firstOfStem[s]; p >= 0; p = next[p]) {
      seen++;
      if (stem[p] !== s || Math.abs(span[2 * p] - at) > 1e-6 || span[2 * p + 1] <= span[2 * p]) wrong++;
      at = span[2 * p + 1];
      if (next[p] >= 0 && (parent[next[p]] !== p || pieces.v[next[p]] !== 1)) wrong++;
    }
    if (at !== 1) wrong++;
    const above = parent[firstOfStem[s]];
    if (above >= 0) {
      // The piece that it hangs on belongs to the parent and covers its place.
      const z = tree.stems.parentZ[s];
      if (stem[above] !== tree.stems.parent[s]) wrong++;
      if (z < span[2 * above] - 1e-6 || z > span[2 * above + 1] + 1e-6) wrong++;
    }
  }
  expect(wrong).toBe(0);
  expect(seen).toBe(count);
}

/**
 * Chains run on without a gap (1e-6), and posed as the wind pass poses them without a kink and without a turn of the frame
 * about the axis. (The stored rest pose is rounded: on short edges its directions are off by more than that.)
 */
export function expectJoints(pieces: Pieces): void {
  let gap = 0;
  let kink = 0;
  let twist = 0;
  for (let i = 0; i < pieces.count; i++) {
    const j = pieces.next[i];
    if (j < 0) continue;
    const a = curveOf(pieces, i);
    const o = Array.from(pieces.orient.subarray(3 * i, 3 * i + 3)) as Vec3;
    const b = attachPiece(a, o, restOf(pieces, j));
    const before = handlesOf(a, o);
    const after = handlesOf(b.curve, b.o);
    gap = Math.max(gap, distance(a.p3, curveOf(pieces, j).p0), distance(a.p3, b.curve.p0));
    kink = Math.max(kink, distance(before.l2, after.l0));
    twist = Math.max(twist, distance(before.t2, after.t0));
  }
  expect(gap).toBeLessThan(1e-6);
  expect(kink).toBeLessThan(1e-9);
  expect(twist).toBeLessThan(1e-9);
}
