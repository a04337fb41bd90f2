import { describe, expect, it } from 'vitest';
import { bezierDerivative, bezierPoint } from '../../../src/core/math/bezier.ts';
import { type Quaternion, rotateByQuaternion } from '../../../src/core/math/quaternion.ts';
import { cross, distance, length, type Mat3, transform, unit, type Vec3 } from '../../../src/core/math/vec3.ts';
import { attachLeaves } from '../../../src/core/pieces/attach-leaves.ts';
import { fitPieces } from '../../../src/core/pieces/fit-pieces.ts';
import { polyline, randomTree, treeOf, upright } from './hand-made-tree.ts';
import { expectJoints, expectOrder } from './invariants.ts';
import { curveOf, frameAt, restError } from './pose-at-rest.ts';

const sideways: Mat3 = [
  [0, 0, -1],
  [0, 1, 0],
  [1, 0, 0],
];

describe('fitPieces on trees made by hand', () => {
  it('makes one straight piece of a stem of one segment', () => {
    const pieces = fitPieces(
      treeOf([
        {
          parent: -1,
          nodes: [
            [1, 2, 0],
            [1, 2, 3],
          ],
        },
      ]),
    );
    expect(pieces.count).toBe(1);
    expect(pieces.maxDepth).toBe(0);
    expect(Array.from(pieces.depthStart)).toEqual([0, 1]);
    expect(Array.from(pieces.control)).toEqual([1, 2, 0, 1, 2, 1, 1, 2, 2, 1, 2, 3]);
    expect(Array.from(pieces.local)).toEqual([1, 2, 0, 0, 3, 0, 0]);
    expect(Array.from(pieces.rootPosition)).toEqual([1, 2, 0]);
    expect(pieces.arc[0]).toBeCloseTo(3, 6);
    expect(Array.from(pieces.span)).toEqual([0, 1]);
  });

  it('follows an arc of 100 degrees with one piece and chains one of 240', () => {
    const arc = (degrees: number) =>
      fitPieces(
        treeOf([
          { parent: -1, nodes: polyline([0, 0, 0], upright, 0.2, Array(12).fill((degrees / 12) * (Math.PI / 180))) },
        ]),
      );
    expect(arc(100).count).toBe(1);
    // The curve starts along the first segment, half a segment's turn off the arc.
    expect(arc(100).deviation[0]).toBeLessThan(0.006);
    const long = arc(240);
    expect(long.count).toBe(2);
    expect(long.deviation[0]).toBeLessThan(0.01);
    expect(Array.from(long.next)).toEqual([1, -1]);
    expect(long.v[1]).toBe(1);
    expect(Array.from(long.orientation.subarray(4))).toEqual([0, 0, 0, 1]);
    expect(long.span[1]).toBe(long.span[2]);
  });

  it('splits a helix at half a turn or before', () => {
    // Declination 45 degrees, two turns: one cubic misses a whole turn by a fifth of its length.
    const n = 32;
    const nodes: Vec3[] = [[0, 0, 0]];
    for (let i = 0; i < n; i++) {
      const a = (4 * Math.PI * (i + 0.5)) / n;
      const [x, y, z] = nodes[i];
      nodes.push([x + Math.cos(a) / n, y + Math.sin(a) / n, z + 1 / n]);
    }
    const pieces = fitPieces(treeOf([{ parent: -1, nodes }]));
    expect(pieces.count).toBeGreaterThanOrEqual(4);
    for (let i = 0; i < pieces.count; i++) expect(pieces.span[2 * i + 1] - pieces.span[2 * i]).toBeLessThan(0.3);
  });

  it('keeps the pieces of three joints that zigzag within tolerance', () => {
    const turns = Array.from({ length: 10 }, (_, i) => (i === 0 ? 0 : (i % 2 ? 1 : -1) * (Math.PI / 3)));
    const pieces = fitPieces(treeOf([{ parent: -1, level: 2, nodes: polyline([0, 0, 0], upright, 0.1, turns) }]));
    expect(pieces.deviation[2]).toBeLessThan(0.02);
    expectJoints(pieces);
  });

  it('hangs children on the piece and the parameter under them', () => {
    const bent = polyline([0, 0, 0], upright, 1, [0, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5]);
    const child = (z: number) => ({ parent: 0, parentZ: z, nodes: polyline([0, 0, 0], sideways, 1, [0]) });
    const pieces = fitPieces(treeOf([{ parent: -1, nodes: bent }, child(0), child(0.2), child(0.9), child(1)]));
    expect(pieces.count).toBe(6);
    const hung = [1, 2, 3, 4].map((stem) => {
      const i = pieces.firstOfStem[stem];
      return { parent: pieces.parent[i], v: pieces.v[i], i };
    });
    expect(hung[0]).toMatchObject({ parent: 0, v: 0 });
    expect(hung[1].parent).toBe(0);
    expect(hung[2].parent).toBe(pieces.next[0]);
    expect(hung[3]).toMatchObject({ parent: pieces.next[0], v: 1 });
    for (const { parent, v, i } of hung) {
      expect(distance(curveOf(pieces, i).p0, bezierPoint(curveOf(pieces, parent), v))).toBeLessThan(1e-6);
      // The direction in tree space is the grown one.
      expect(distance(unit(bezierDerivative(curveOf(pieces, i), 0)), [1, 0, 0])).toBeLessThan(1e-6);
    }
    const { v } = hung[1];
    const { z0, z1 } = { z0: pieces.span[0], z1: pieces.span[1] };
    let arc = 0;
    for (let k = 0; k < 1000; k++)
      arc += length(bezierDerivative(curveOf(pieces, 0), (v * (k + 0.5)) / 1000)) * (v / 1000);
    expect(arc / pieces.arc[0]).toBeCloseTo((0.2 - z0) / (z1 - z0), 4);
  });

  it('starts a clone at the split of its twin, covering the rest of the span', () => {
    const nodes = polyline([0, 0, 0], upright, 1, [0, 0.1, 0.1, 0.1]);
    const clone = {
      parent: 0,
      parentZ: 0.5,
      zStart: 0.5,
      clone: true,
      level: 0,
      length: 4,
      nodes: polyline(nodes[2], sideways, 1, [0, 0.2]),
    };
    const pieces = fitPieces(treeOf([{ parent: -1, nodes }, clone]));
    const i = pieces.firstOfStem[1];
    expect(Array.from(pieces.span.subarray(2 * i, 2 * i + 2))).toEqual([0.5, 1]);
    expect(pieces.v[i]).toBeCloseTo(0.5, 1);
    expect(distance(curveOf(pieces, i).p0, nodes[2])).toBeLessThan(0.04);
  });

  it('puts several trunks first, where they stand', () => {
    const trunk = (x: number) => ({
      parent: -1,
      nodes: [
        [x, 0, 0],
        [x, 0, 2],
      ] as Vec3[],
    });
    const pieces = fitPieces(
      treeOf([
        trunk(0),
        {
          parent: 0,
          parentZ: 0.5,
          nodes: [
            [0, 0, 1],
            [1, 0, 1],
          ],
        },
        trunk(5),
      ]),
    );
    expect(Array.from(pieces.depthStart)).toEqual([0, 2, 3]);
    expect(Array.from(pieces.rootPosition)).toEqual([0, 0, 0, 5, 0, 0]);
    expect(Array.from(pieces.parent)).toEqual([-1, -1, 0]);
  });

  it('gives a stem without length the direction of its frame', () => {
    const tree = treeOf([
      { parent: -1, nodes: polyline([0, 0, 0], upright, 1, [0, 0.2]) },
      { parent: 0, parentZ: 1, nodes: polyline([0, 0, 2], upright, 1, [0]) },
      { parent: 0, parentZ: 0.5, nodes: polyline([0, 0, 1], upright, 1, [0, 0, 0]) },
    ]);
    const { nodePosition, nodeStart } = tree.stems;
    nodePosition.fill(0, 3 * nodeStart[1]);
    const pieces = fitPieces(tree);
    expect(pieces.count).toBe(3);
    for (const array of [pieces.control, pieces.orientation, pieces.local, pieces.arc, pieces.v]) {
      expect(array.every(Number.isFinite)).toBe(true);
    }
    expect(restError(pieces).position).toBeLessThan(1e-6);
  });

  it('takes a tree without stems', () => {
    const pieces = fitPieces(treeOf([]));
    expect(pieces.count).toBe(0);
    expect(Array.from(pieces.depthStart)).toEqual([0, 0]);
  });

  it.each([1, 2, 3, 4])('keeps its invariants on random trees (seed %i)', (seed) => {
    const tree = randomTree(seed);
    const pieces = fitPieces(tree);
    expectOrder(pieces, tree);
    expectJoints(pieces);
    const { position, orient } = restError(pieces);
    expect(position).toBeLessThan(2e-5 * 10);
    expect(orient).toBeLessThan(2e-4);
    for (const [level, d] of pieces.deviation.entries()) expect(d).toBeLessThanOrEqual(level === 0 ? 0.01 : 0.02);
  });
});

describe('attachLeaves', () => {
  it('keeps each leaf in its tree-space orientation, on its piece', () => {
    const tree = randomTree(5, [1, 4, 4, 2], 3);
    const { leaves } = tree;
    // Half of the leaves sit on bent stems of level 1 and 2 instead of straight twigs.
    for (let i = 0; i < leaves.count; i += 2) leaves.stem[i] = tree.stems.parent[leaves.stem[i]];
    const pieces = fitPieces(tree);
    const hung = attachLeaves(tree, pieces);
    for (let i = 0; i < leaves.count; i++) {
      const p = hung.piece[i];
      expect(pieces.stem[p]).toBe(leaves.stem[i]);
      const z = Math.max(leaves.z[i], tree.stems.zStart[leaves.stem[i]]);
      expect(z).toBeGreaterThanOrEqual(pieces.span[2 * p] - 1e-6);
      expect(z).toBeLessThanOrEqual(pieces.span[2 * p + 1] + 1e-6);
      const frame = frameAt(pieces, p, hung.v[i]);
      for (const axis of [
        [1, 0, 0],
        [0, 0, 1],
      ] as Vec3[]) {
        const grown = rotateByQuaternion(Array.from(leaves.orientation.subarray(4 * i, 4 * i + 4)) as Quaternion, axis);
        const local = rotateByQuaternion(Array.from(hung.orientation.subarray(4 * i, 4 * i + 4)) as Quaternion, axis);
        expect(distance(transform(frame, local), grown)).toBeLessThan(2e-6);
      }
      expect(length(cross(frame[0], frame[1]))).toBeCloseTo(1, 6);
    }
  });
});
