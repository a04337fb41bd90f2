import { describe, expect, it } from 'vitest';
import type { Tree } from '../../../src/core/grow/tree.ts';
import { bezierDerivative, bezierPoint, type Cubic } from '../../../src/core/math/bezier.ts';
import { cross, subtract, unit, type Vec3 } from '../../../src/core/math/vec3.ts';
import { hashPacked } from '../../../src/core/pack/hash-packed.ts';
import { leafTexel } from '../../../src/core/pack/leaf-texel.ts';
import { packTree } from '../../../src/core/pack/pack.ts';
import type { PackedTree } from '../../../src/core/pack/packed.ts';
import { unpackBranch, unpackPiece, unpackPose } from '../../../src/core/pack/unpack.ts';
import { attachLeaves } from '../../../src/core/pieces/attach-leaves.ts';
import { fitPieces } from '../../../src/core/pieces/fit-pieces.ts';
import type { LeafAttachments, Pieces } from '../../../src/core/pieces/pieces.ts';
import { anySpecies, randomTree, treeOf } from '../pieces/hand-made-tree.ts';
import { curveOf } from '../pieces/pose-at-rest.ts';

function packed(tree: Tree): { tree: Tree; pieces: Pieces; hung: LeafAttachments; pack: PackedTree } {
  const pieces = fitPieces(tree);
  const hung = attachLeaves(tree, pieces);
  return { tree, pieces, hung, pack: packTree(tree, pieces, hung) };
}

const curveFrom = ([p0, p1, p2, p3]: readonly Vec3[]): Cubic => ({ p0, p1, p2, p3 }) as Cubic;

const floats = (a: Float32Array, from: number, count: number): number[] => Array.from(a.subarray(from, from + count));

describe('packTree', () => {
  const { tree, pieces, hung, pack } = packed(randomTree(11));
  const { stems, leaves } = tree;

  it('gives every piece back', () => {
    expect(pack.pieceCount).toBe(pieces.count);
    for (let i = 0; i < pieces.count; i++) {
      const read = unpackPiece(pack, i);
      expect(read.parent).toBe(pieces.parent[i]);
      expect(read.v).toBe(pieces.v[i]);
      expect(read.orientation).toEqual(floats(pieces.orientation, 4 * i, 4));
      expect([read.p1[0], ...read.p2, ...read.p3]).toEqual(floats(pieces.local, 7 * i, 7));
      expect(read.arc).toBe(pieces.arc[i]);
      expect(read.third).toBeCloseTo(stems.length[pieces.stem[i]] / 3, 6);
      let last = i;
      while (pieces.next[last] >= 0) last = pieces.next[last];
      expect(read.tip).toEqual(floats(pieces.control, 12 * last + 9, 3));
    }
  });

  it('shares the bend of a stem among its pieces, over its stiffness', () => {
    const g = (z: number): number => z ** 1.8;
    for (let i = 0; i < pieces.count; i++) {
      const [z0, z1] = floats(pieces.span, 2 * i, 2);
      const stiffness = anySpecies.wind.stiffness[pieces.level[i]];
      const [w2, w3] = unpackPiece(pack, i).weights;
      expect(w2 * stiffness).toBeCloseTo(g(z0 + (z1 - z0) / 3) - g(z0), 6);
      expect(w3 * stiffness).toBeCloseTo(g(z1) - g(z0), 6);
    }
  });

  it('gives the rest pose back', () => {
    expect([pack.restPose.width, pack.restPose.height]).toEqual([pack.pieces.width, pack.pieces.height]);
    for (let i = 0; i < pieces.count; i++) {
      const pose = unpackPose(pack.restPose, i);
      expect(pose.points.flat()).toEqual(floats(pieces.control, 12 * i, 12));
      expect(pose.orient).toEqual(floats(pieces.orient, 3 * i, 3));
      expect(pose.bend).toBe(0);
    }
  });

  it('draws every piece once, grouped by level', () => {
    const seen = new Set<number>();
    expect(pack.levels.reduce((sum, range) => sum + range.count, 0)).toBe(pieces.count);
    pack.levels.forEach(({ start, count }, level) => {
      for (let k = start; k < start + count; k++) {
        const read = unpackBranch(pack, k);
        seen.add(read.piece);
        const stem = pieces.stem[read.piece];
        expect(pieces.level[read.piece]).toBe(level);
        expect([read.z0, read.z1]).toEqual(floats(pieces.span, 2 * read.piece, 2));
        expect(read.baseRadius).toBe(stems.baseRadius[stem]);
        expect(read.length).toBe(stems.length[stem]);
        expect(read.depth).toBe(pieces.depth[read.piece]);
        expect(read.phase).toBeGreaterThanOrEqual(0);
        expect(read.phase).toBeLessThan(1);
      }
    });
    expect(seen.size).toBe(pieces.count);
  });

  it("knows the parent's radius where a stem starts, and gives a clone its twin's bark", () => {
    const nodes: [number, number, number][] = [
      [0, 0, 0],
      [0, 0, 4],
    ];
    const made = packed(
      treeOf([
        { parent: -1, nodes, radius: 0.2 },
        { parent: 0, parentZ: 0.5, nodes, radius: 0.05 },
        { parent: 0, parentZ: 0.25, zStart: 0.25, clone: true, level: 0, nodes, radius: 0.2 },
      ]),
    );
    const byPiece = new Map([0, 1, 2].map((k) => [unpackBranch(made.pack, k).piece, unpackBranch(made.pack, k)]));
    const of = (stem: number) => byPiece.get(made.pieces.firstOfStem[stem])!;
    // The aspen's trunk is a cone (taper 1).
    expect(of(0).parentRadius).toBe(0);
    expect(of(1).parentRadius).toBeCloseTo(0.1, 2);
    expect(of(2).parentRadius).toBeCloseTo(0.15, 2);
    expect(of(2).phase).toBe(of(0).phase);
    expect(of(1).phase).not.toBe(of(0).phase);
  });

  it("knows how the parent's axis stands to the first piece of a stem, and of no other", () => {
    let joints = 0;
    for (let k = 0; k < pack.pieceCount; k++) {
      const { piece, parentAxis } = unpackBranch(pack, k);
      const stem = pieces.stem[piece];
      if (stems.parent[stem] < 0 || pieces.firstOfStem[stem] !== piece) {
        expect(parentAxis).toEqual([0, 0, 0]);
        continue;
      }
      joints++;
      const parent = unpackPose(pack.restPose, pieces.parent[piece]).points;
      const tangent = unit(bezierDerivative(curveFrom(parent), pieces.v[piece]));
      const { points, orient } = unpackPose(pack.restPose, piece);
      const first = unit(subtract(points[1], points[0]));
      const across = cross(first, orient);
      const told = [0, 1, 2].map(
        (i) => parentAxis[0] * first[i] + parentAxis[1] * orient[i] + parentAxis[2] * across[i],
      );
      expect(Math.hypot(...told.map((x, i) => x - tangent[i]))).toBeLessThan(1e-3);
    }
    expect(joints).toBeGreaterThan(5);
  });

  it('gives every leaf back, once', () => {
    const key = (a: readonly number[]): string => a.join();
    const grown = Array.from({ length: leaves.count }, (_, i) =>
      key([
        hung.piece[i],
        Math.round(hung.v[i] * 65535),
        Math.round(leaves.phase[i] * 65535),
        ...floats(hung.orientation, 4 * i, 4).map((x) => Math.floor(x * 32767 + 0.5)),
      ]),
    );
    const read = Array.from({ length: pack.leafCount }, (_, k) => {
      const leaf = leafTexel(pack.leaves.data, k);
      expect(leaf.odd).toBe(pieces.depth[leaf.piece] % 2 === 1);
      const back = [leaf.v * 65535, leaf.phase * 65535, ...leaf.orientation.map((x) => x * 32767)];
      return key([leaf.piece, ...back.map((x) => Math.round(x))]);
    });
    expect(read.sort()).toEqual(grown.sort());
  });

  it('makes textures a power of two wide, at least 16, and no higher than needed', () => {
    for (const [array, count] of [
      [pack.pieces, pack.pieceCount],
      [pack.branches, pack.pieceCount],
      [pack.leaves, pack.leafCount],
    ] as const) {
      expect(Math.log2(array.width) % 1).toBe(0);
      expect(array.width).toBeGreaterThanOrEqual(16);
      expect(array.width).toBeGreaterThanOrEqual(Math.sqrt(count));
      expect(array.width * array.height).toBeGreaterThanOrEqual(count);
      expect(array.width * (array.height - 1)).toBeLessThan(count);
      expect(array.data.length).toBe(array.width * array.height * array.layers * 4);
    }
  });

  it('boxes in all curves and leaves', () => {
    const [x0, y0, z0, x1, y1, z1] = pack.bounds;
    const inside = ([x, y, z]: number[]): boolean => x0 < x && x < x1 && y0 < y && y < y1 && z0 < z && z < z1;
    for (let i = 0; i < pieces.count; i++) {
      for (const u of [0, 0.5, 1]) expect(inside(bezierPoint(curveOf(pieces, i), u))).toBe(true);
    }
    expect(z1).toBeLessThan(25);
    const [cx, cy, cz, rx, ry, rz] = pack.crown;
    expect(inside([cx, cy, cz])).toBe(true);
    expect(Math.min(rx, ry, rz)).toBeGreaterThan(1);
    // Two thirds and more of the leaves lie inside the ellipsoid.
    let within = 0;
    for (let i = 0; i < leaves.count; i++) {
      const [x, y, z] = bezierPoint(curveOf(pieces, hung.piece[i]), hung.v[i]);
      if (((x - cx) / rx) ** 2 + ((y - cy) / ry) ** 2 + ((z - cz) / rz) ** 2 < 1) within++;
    }
    expect(within / leaves.count).toBeGreaterThan(0.6);
  });

  it('packs a tree without leaves, and one without anything', () => {
    const bare = packed(randomTree(12, [1, 4], 0)).pack;
    expect(bare.leafCount).toBe(0);
    expect(bare.crown.every(Number.isFinite)).toBe(true);
    expect(bare.crown[3]).toBeGreaterThan(0);
    const nothing = packed(treeOf([])).pack;
    expect(nothing.pieceCount).toBe(0);
    expect(Array.from(nothing.bounds)).toEqual([0, 0, 0, 0, 0, 0]);
    expect(nothing.pieces.data.every((x) => x === 0)).toBe(true);
  });

  it('has a hash that any changed bit changes', () => {
    const again = packed(randomTree(11)).pack;
    expect(hashPacked(again)).toBe(hashPacked(pack));
    expect(hashPacked(packed(randomTree(12)).pack)).not.toBe(hashPacked(pack));
    const at = again.leaves.data.length - 5;
    again.leaves.data[at] ^= 1;
    expect(hashPacked(again)).not.toBe(hashPacked(pack));
  });
});
