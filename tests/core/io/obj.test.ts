import { decode } from 'fast-png';
import type { Mesh, MeshPhongMaterial } from 'three';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { expect, test } from 'vitest';
import { DEFAULT_EXPORT } from '../../../src/core/io/export-options.ts';
import { exportTree } from '../../../src/core/io/export-tree.ts';
import { meshTree } from '../../../src/core/mesh/tree-mesh.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { STILL } from '../../../src/core/wind/wind.ts';
import { shippedSpecies } from '../pack/shipped-species.ts';

const aspen = shippedSpecies('quaking-aspen');
const grown = growPacked(aspen, 2);
const options = {
  ...DEFAULT_EXPORT,
  format: 'obj',
  detail: 'low',
  levels: 3,
  textures: '128',
  mostLeaves: 400,
} as const;
const mesh = meshTree(grown, { detail: 'low', levels: 3, mostLeaves: 400 });
const files = await exportTree(aspen, 2, STILL, options, undefined, { grown });
const textOf = (ending: string): string =>
  new TextDecoder().decode(files.find(({ name }) => name.endsWith(ending))?.bytes);
const [obj, mtl] = [textOf('.obj'), textOf('.mtl')];

test('an OBJ is read by another program as the mesh that was written, in groups of levels and leaves', () => {
  const meshes = new OBJLoader().parse(obj).children as Mesh[];
  expect(meshes.map(({ name }) => name)).toEqual([
    'level-0',
    'level-1',
    'level-2',
    'level-1-twigs',
    'level-2-twigs',
    'leaves',
  ]);
  const triangles = meshes.map(({ geometry }) => geometry.getAttribute('position').count / 3);
  const stems = triangles.slice(0, -1).reduce((a, b) => a + b, 0);
  expect(stems).toBe(mesh.triangleCount);
  expect(triangles.at(-1)).toBe(mesh.leaves!.count * (mesh.leaves!.leaf.index.length / 3));
  const trunk = meshes[0]!.geometry;
  trunk.computeBoundingBox();
  const box = trunk.boundingBox!;
  // y up: the tree's z.
  expect(box.max.y).toBeGreaterThan(0.8 * grown.stats.height);
  let [high, x0] = [0, 0];
  for (let i = 0; i < mesh.vertexCount; i++)
    if (mesh.level[i] === 0) {
      high = Math.max(high, mesh.position[3 * i + 2]!);
      x0 = Math.min(x0, mesh.position[3 * i]!);
    }
  expect(box.max.y).toBeCloseTo(high, 4);
  expect(box.min.x).toBeCloseTo(x0, 4);
});

test('its triangles face outwards as their normals do', () => {
  for (const { geometry } of new OBJLoader().parse(obj).children as Mesh[]) {
    const [position, normal] = [geometry.getAttribute('position'), geometry.getAttribute('normal')];
    let [agree, all] = [0, 0];
    for (let t = 0; t < position.count; t += 3) {
      const p = (k: number): number[] => [position.getX(t + k), position.getY(t + k), position.getZ(t + k)];
      const [a, b, c] = [p(0), p(1), p(2)] as [number[], number[], number[]];
      const e = b.map((x, k) => x - a[k]!) as [number, number, number];
      const f = c.map((x, k) => x - a[k]!) as [number, number, number];
      const n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
      const dot = n[0]! * normal.getX(t) + n[1]! * normal.getY(t) + n[2]! * normal.getZ(t);
      agree += dot > 0 ? 1 : 0;
      all += 1;
    }
    expect(agree / all).toBeGreaterThan(0.97);
  }
});

test('its materials have names that it uses, colours, and images that are there', () => {
  expect(obj).toContain('mtllib quaking-aspen-2.mtl');
  const used = new Set([...obj.matchAll(/^usemtl (.+)$/gm)].map(([, name]) => name));
  const made = [...mtl.matchAll(/^newmtl (.+)$/gm)].map(([, name]) => name);
  expect(made).toEqual(['bark', 'twigs', 'leaves']);
  expect([...used].sort()).toEqual(['bark', 'leaves', 'twigs']);
  for (const [, image] of mtl.matchAll(/^(?:map_Kd|norm|map_Bump) (.+)$/gm)) {
    const file = files.find(({ name }) => name === image);
    const { width, height, channels } = decode(file!.bytes);
    expect([width, height, channels]).toEqual([128, 128, 3]);
  }
  const materials = new MTLLoader().parse(mtl.replace(/^(map_|norm).*$/gm, ''), '');
  const leaves = materials.create('leaves') as MeshPhongMaterial;
  expect(`#${leaves.color.getHexString()}`).toBe(aspen.foliage.colour);
});

test('without images the bark has its colour', async () => {
  const plain = await exportTree(aspen, 2, STILL, { ...options, textures: 'none' }, undefined, { grown });
  expect(plain.map(({ name }) => name)).toEqual(['quaking-aspen-2.obj', 'quaking-aspen-2.mtl']);
  const text = new TextDecoder().decode(plain[1]!.bytes);
  expect(text).not.toMatch(/map_|norm /);
  expect(text.split('newmtl')[1]).toContain('Kd 0.851 0.8549 0.7765');
});
