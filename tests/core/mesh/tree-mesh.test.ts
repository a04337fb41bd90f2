import { describe, expect, it } from 'vitest';
import { collar } from '../../../src/core/deform/collar.ts';
import { stemRadius } from '../../../src/core/deform/radius.ts';
import { surfacePoint } from '../../../src/core/deform/surface.ts';
import { GRAINS_PER_TILE } from '../../../src/core/look/bark-tile.ts';
import { handlesOf } from '../../../src/core/math/frames.ts';
import { expandLeaves } from '../../../src/core/mesh/expand-leaves.ts';
import { COLLAR, levelShape } from '../../../src/core/mesh/level-shape.ts';
import { pieceTable } from '../../../src/core/mesh/piece-table.ts';
import { meshTree, type TreeMesh } from '../../../src/core/mesh/tree-mesh.ts';
import type { GrownPacked } from '../../../src/core/pack/grow-packed.ts';
import { createWindState, windStateAt } from '../../../src/core/wind/fade.ts';
import { planeOf, poseOf } from '../../../src/core/wind/pose-plainly.ts';
import { poseTree } from '../../../src/core/wind/pose-tree.ts';
import { GALE } from '../wind/some-winds.ts';
import { smallTrees } from './small-trees.ts';

const GRADES = ['far', 'low', 'medium', 'high'] as const;

const inGale = ({ packed }: GrownPacked): Float32Array =>
  poseTree(packed, windStateAt({ ...GALE, model: 'direct' }, 7, undefined, createWindState()), 'exact');

/** Largest distance, and largest difference of normals and tangents, from the deformer's twin. */
function offTwin(grown: GrownPacked, mesh: TreeMesh, pose: Float32Array) {
  const { packed, tree, pieces } = grown;
  const table = pieceTable(packed);
  const plane = planeOf(packed.restPose);
  const off = { place: 0, normal: 0, around: 0, level: 0 };
  for (let i = 0; i < mesh.vertexCount; i++) {
    const piece = mesh.piece[i];
    const level = pieces.level[piece];
    if (mesh.level[i] !== level) off.level++;
    const { curve, o } = poseOf(pose, plane, piece);
    const [z0, part] = [table.z0[piece], table.z1[piece] - table.z0[piece]];
    const z = z0 + part * mesh.u[i];
    const repeats = Math.max(1, Math.floor((2 * Math.PI * table.baseRadius[piece]) / tileOf(grown) + 0.5));
    const turns = (mesh.uv[2 * i] - table.phase[piece]) / repeats;
    const stem = table.length[piece];
    const [r, byZ, q] = stemRadius(levelShape(tree.species, level), table.baseRadius[piece], stem, z, turns);
    const [swell, slope] = collar(z * stem, r, table.parentRadius[piece], COLLAR);
    const [c, s] = [Math.cos(2 * Math.PI * turns), Math.sin(2 * Math.PI * turns)];
    const rhoU = part * (byZ * swell + r * slope * stem);
    const twin = surfacePoint(curve, handlesOf(curve, o), mesh.u[i], c, s, r * swell, rhoU, q);
    const at = mesh.position.subarray(3 * i, 3 * i + 3);
    const distance = Math.hypot(...twin.position.map((x, k) => x - at[k]));
    // The middle of a cap lies on the axis and looks along it.
    const axis = distance > 1e-4 && Math.abs(distance - r * swell) < 1e-4 * (1 + r);
    if (axis) continue;
    off.place = Math.max(off.place, distance);
    off.normal = Math.max(off.normal, Math.hypot(...twin.normal.map((x, k) => x - mesh.normal[3 * i + k])));
    off.around = Math.max(off.around, Math.hypot(...twin.around.map((x, k) => x - mesh.tangent[4 * i + k])));
  }
  return off;
}

const tileOf = ({ tree }: GrownPacked): number => tree.species.bark.grain * GRAINS_PER_TILE[tree.species.bark.kind];

/** Twice the area of a triangle, and its normal along the mean of its corners' normals. */
function triangle({ position, normal, index }: Pick<TreeMesh, 'position' | 'normal' | 'index'>, t: number) {
  const [a, b, c] = [3 * index[t], 3 * index[t + 1], 3 * index[t + 2]];
  const e = [0, 1, 2].map((k) => position[b + k] - position[a + k]);
  const f = [0, 1, 2].map((k) => position[c + k] - position[a + k]);
  const n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
  const along = n.reduce((sum, x, k) => sum + x * (normal[a + k] + normal[b + k] + normal[c + k]), 0);
  return { area: Math.hypot(...n), along };
}

describe.each(smallTrees)('mesh of %s', (name, grown) => {
  // Between two balls the surface has a crease, where normals are on either side of what the triangles are.
  const creased = name === 'strings of balls';

  it.each(GRADES)('%s: lies on the deformed surface, at rest and in a gale', (detail) => {
    for (const pose of [grown.packed.restPose.data, inGale(grown)]) {
      const off = offTwin(grown, meshTree(grown, { detail, leaves: false, pose }), pose);
      expect(off.level).toBe(0);
      expect(off.place).toBeLessThan(1e-5);
      expect(off.normal).toBeLessThan(creased ? 1e-2 : 2e-4);
      expect(off.around).toBeLessThan(1e-4);
    }
  });

  it.each(GRADES)('%s: has an area everywhere, faces out, and is finite', (detail) => {
    const mesh = meshTree(grown, { detail });
    expect(mesh.triangleCount).toBeGreaterThan(20);
    let against = 0;
    for (let t = 0; t < mesh.index.length; t += 3) {
      const { area, along } = triangle(mesh, t);
      expect(area).toBeGreaterThan(0);
      if (along <= 0) against++;
    }
    expect(against / mesh.triangleCount).toBeLessThanOrEqual(creased ? 0.05 : 0);
    for (const numbers of [mesh.position, mesh.normal, mesh.tangent, mesh.uv, mesh.u, mesh.v]) {
      expect(numbers.every(Number.isFinite)).toBe(true);
    }
    expect(Math.max(...mesh.index)).toBe(mesh.vertexCount - 1);
    expect(mesh.parts.reduce((sum, part) => sum + part.indexCount, 0)).toBe(mesh.index.length);
  });

  it('is closed but for the base of each stem: every other edge has two triangles, by where its ends are', () => {
    const mesh = meshTree(grown, { detail: 'medium', leaves: false });
    const name = (i: number): string => mesh.position.subarray(3 * i, 3 * i + 3).join();
    // Stems may touch each other at a point: an edge is one of a stem.
    const stem = (i: number): number => grown.pieces.stem[mesh.piece[i]];
    const edges = new Map<string, { count: number; base: boolean }>();
    for (let t = 0; t < mesh.index.length; t += 3) {
      for (let k = 0; k < 3; k++) {
        const [a, b] = [mesh.index[t + k], mesh.index[t + ((k + 1) % 3)]];
        const key = `${stem(a)}: ${[name(a), name(b)].sort().join(' ')}`;
        const found = edges.get(key) ?? { count: 0, base: mesh.u[a] === 0 && mesh.u[b] === 0 };
        found.count++;
        edges.set(key, found);
      }
    }
    const open = [...edges.values()].filter(({ count, base }) => count !== (base ? 1 : 2));
    expect(open).toEqual([]);
  });

  it('is the same each time, and has the same triangles in every pose', () => {
    const [a, b] = [meshTree(grown, { detail: 'low' }), meshTree(grown, { detail: 'low' })];
    expect(b).toEqual(a);
    const blown = meshTree(grown, { detail: 'low', pose: inGale(grown) });
    expect(blown.index).toEqual(a.index);
    expect(blown.position).not.toEqual(a.position);
  });

  it('leaves out deeper levels with their leaves, and leaves where none are wanted', () => {
    const two = meshTree(grown, { detail: 'low', levels: 2 });
    expect(Math.max(...two.level)).toBe(1);
    expect(two.leaves).toBeNull();
    expect(meshTree(grown, { detail: 'low', leaves: false }).leaves).toBeNull();
  });
});

describe.each(smallTrees.slice(0, 2))('leaves of %s', (_, grown) => {
  it('hang where the tree has them, turned as it has them', () => {
    const { leaves } = meshTree(grown, { detail: 'high' });
    const { attachments, tree, packed } = grown;
    expect(leaves?.count).toBe(packed.leafCount);
    if (!leaves) return;
    // The draw order is another than that in which they grew: each must be one of them.
    const grew = new Map<string, number[]>();
    for (let i = 0; i < tree.leaves.count; i++) {
      const key = `${attachments.piece[i]} ${Math.round(attachments.v[i] * 65535)}`;
      grew.set(key, [...(grew.get(key) ?? []), i]);
    }
    for (let i = 0; i < leaves.count; i++) {
      const found = grew.get(`${leaves.piece[i]} ${Math.round(leaves.u[i] * 65535)}`) ?? [];
      const off = found.map((k) => {
        const same = [0, 1, 2, 3].reduce(
          (s, n) => s + tree.leaves.orientation[4 * k + n] * leaves.quaternion[4 * i + n],
          0,
        );
        return 1 - Math.abs(same);
      });
      expect(Math.min(...off)).toBeLessThan(1e-6);
    }
  });

  it('as triangles face the way of their normals, and stay within a leaf of their places', () => {
    const { leaves } = meshTree(grown, { detail: 'medium' });
    if (!leaves) throw new Error('no leaves');
    const triangles = expandLeaves(leaves);
    expect(triangles.triangleCount).toBe((leaves.count * leaves.leaf.index.length) / 3);
    const reach = Math.max(...leaves.leaf.position.map(Math.abs)) * 1.8;
    for (let i = 0; i < triangles.vertexCount; i++) {
      const foot = leaves.position.subarray(3 * triangles.leaf[i], 3 * triangles.leaf[i] + 3);
      expect(Math.hypot(...foot.map((x, k) => x - triangles.position[3 * i + k]))).toBeLessThan(reach);
    }
    for (let t = 0; t < triangles.index.length; t += 3) expect(triangle(triangles, t).along).toBeGreaterThan(0);
  });

  it('become fewer and larger where not all are wanted', () => {
    const all = meshTree(grown, { detail: 'medium' }).leaves;
    const some = meshTree(grown, { detail: 'medium', mostLeaves: 10 }).leaves;
    expect(some?.count).toBe(10);
    const size = (leaves: typeof all) => Math.max(...(leaves?.leaf.position ?? [0]));
    expect(size(some)).toBeGreaterThan(size(all));
  });
});
