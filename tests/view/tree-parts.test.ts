import { type InstancedBufferGeometry, type Mesh, type MeshStandardMaterial, PerspectiveCamera, Sphere } from 'three';
import { expect, test } from 'vitest';
import { growPacked } from '../../src/core/pack/grow-packed.ts';
import { windBox } from '../../src/view/tree-extent.ts';
import { TreeParts } from '../../src/view/tree-parts.ts';
import { wholeKit } from '../../src/view/whole-kit.ts';
import { shippedSpecies } from '../core/pack/shipped-species.ts';

const species = shippedSpecies('quaking-aspen');
const { packed } = growPacked(species, 1);

/** A camera from which the whole tree is seen. */
function camera(distance: number): PerspectiveCamera {
  const eye = new PerspectiveCamera(30, 1, 0.1, 1000);
  eye.position.set(0, 6, distance);
  eye.updateMatrixWorld();
  return eye;
}

const parts = (): TreeParts =>
  new TreeParts(
    { mode: 'shaded', levels: Number.POSITIVE_INFINITY, leaves: true, detail: 'auto', leafBudget: 20_000 },
    wholeKit,
  );

test('a tree that is given after all was freed is drawn whole, leaves and control polygons too', () => {
  const tree = parts();
  tree.setTree(packed, species);
  tree.update(camera(30));
  const meshes = tree.children.length;
  expect(meshes).toBe(packed.levels.length + 1);
  tree.dispose();
  expect(tree.children).toEqual([]);
  tree.setTree(packed, species);
  tree.update(camera(30));
  expect(tree.children.length).toBe(meshes);
  tree.shown.mode = 'control';
  tree.update(camera(30));
  expect(tree.children.length).toBe(meshes + 1);
});

test('materials that are dropped twice, with nothing drawn between, or freed after it, are none to the next look', () => {
  const tree = parts();
  tree.setTree(packed, species);
  tree.update(camera(30));
  for (const channel of ['sway', null, 'sway', null] as const) {
    tree.setChannel(channel, null);
    tree.shown.mode = 'wireframe';
    tree.applyMode();
  }
  tree.update(camera(30));
  const materials = tree.children.map((mesh) => (mesh as Mesh).material as MeshStandardMaterial);
  expect(materials.every(({ wireframe }) => wireframe)).toBe(true);
  tree.setChannel('sway', null);
  tree.dispose();
  expect(tree.children).toEqual([]);
});

test('geometry is made anew where it must look another way, and not from frame to frame', () => {
  const tree = parts();
  tree.setTree(packed, species);
  const geometries = (distance: number): unknown[] => {
    tree.update(camera(distance));
    return tree.children
      .filter(({ visible }) => visible)
      .map((mesh) => (mesh as unknown as { geometry: unknown }).geometry);
  };
  const near = geometries(8);
  geometries(8).forEach((geometry, i) => {
    expect(geometry).toBe(near[i]);
  });
  geometries(400).forEach((geometry, i) => {
    expect(geometry).not.toBe(near[i]);
  });
  const wide = geometries(400);
  tree.setTree(packed, { ...species, leaves: { ...species.leaves, scaleX: 0.5 } });
  const narrow = geometries(400);
  expect(narrow.at(-1)).not.toBe(wide.at(-1));
  // Another tree's stems are as many copies of the same grid.
  expect(narrow.slice(0, -1)).toEqual(wide.slice(0, -1));
  const other = growPacked(species, 2).packed;
  tree.setTree(other, species);
  const [first] = geometries(400) as InstancedBufferGeometry[];
  expect(first).toBe(wide[0]);
  // From afar fewer twigs, each wider.
  expect(tree.stats().pieces).toBeLessThan(0.5 * other.pieceCount);
  expect(first?.boundingSphere?.radius).toBeCloseTo(windBox(other.bounds).getBoundingSphere(new Sphere()).radius, 6);
  geometries(8);
  expect(tree.stats().pieces).toBe(other.pieceCount);
});
