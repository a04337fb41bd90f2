import { Box3, Mesh } from 'three';
import { expect, test } from 'vitest';
import { branchGeometry, recount } from '../../src/view/branch-geometry.ts';
import { castCoarsely } from '../../src/view/coarse-shadow.ts';

test('shadow maps draw the ribbon behind the tube, and the picture the tube again', () => {
  const geometry = branchGeometry({ sectors: 8, bands: 4, cap: true, bundle: 2 }, 5, new Box3(), 3);
  const mesh = new Mesh(geometry);
  castCoarsely(mesh);
  const tube = 2 * 3 * (2 * 8 * 4 + 8);
  const call = (hook: unknown): void => (hook as (...args: unknown[]) => void)(null, mesh, null, null, geometry);
  recount(geometry, 7, 2, new Box3(), 3);
  expect([geometry.drawRange, geometry.instanceCount]).toEqual([{ start: 0, count: tube }, 4]);
  call(mesh.onBeforeShadow);
  expect([geometry.drawRange, geometry.instanceCount]).toEqual([{ start: tube, count: 2 * 3 * 2 * 3 }, 2]);
  const { array } = geometry.index!;
  expect(Math.min(...array.subarray(tube))).toBe(2 * (5 * 9 + 9));
  call(mesh.onAfterShadow);
  expect([geometry.drawRange, geometry.instanceCount]).toEqual([{ start: 0, count: tube }, 4]);
});
