import { type Box3, BufferAttribute, InstancedBufferGeometry, Sphere } from 'three';
import type { LeafMesh } from '../core/look/leaf-mesh.ts';
import { branchGrid, type GridSpec } from './grid.ts';

/** Copies of a grid or a leaf in one instance: an instance costs a software rasteriser as much as thirty vertices. */
export const BUNDLE = 64;

/** Copies that waste nothing where there are few things to draw. */
export const bundleFor = (count: number): number => Math.max(1, Math.min(BUNDLE, count));

/** Instances that hold `count` copies. */
const instances = (count: number, bundle: number): number => Math.ceil(count / bundle);

function bounded(geometry: InstancedBufferGeometry, box: Box3): InstancedBufferGeometry {
  // The vertices are made in the shader, so three cannot find the bounds itself.
  geometry.boundingBox = box.clone();
  geometry.boundingSphere = box.getBoundingSphere(new Sphere());
  return geometry;
}

/** Draws other pieces or leaves with the same copies: `count` of them within `box`. */
export function recount(geometry: InstancedBufferGeometry, count: number, bundle: number, box: Box3): void {
  const { userData } = geometry;
  userData.triangles = (userData.triangles / userData.count) * count;
  userData.count = count;
  geometry.instanceCount = instances(count, bundle);
  bounded(geometry, box);
}

/** A grid as instanced geometry over `count` pieces; `box` bounds them in tree space. */
export function branchGeometry(spec: GridSpec, count: number, box: Box3): InstancedBufferGeometry {
  const grid = branchGrid(spec);
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(grid.position, 3));
  geometry.setAttribute('normal', new BufferAttribute(grid.shape, 3));
  geometry.setIndex(new BufferAttribute(grid.index, 1));
  geometry.instanceCount = instances(count, spec.bundle);
  Object.assign(geometry.userData, { count, triangles: grid.trianglesPerCopy * count });
  return bounded(geometry, box);
}

/** Leaves, `bundle` copies a mesh, as instanced geometry over `count` of them; `box` bounds them in tree space. */
export function leafGeometry(mesh: LeafMesh, count: number, bundle: number, box: Box3): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.position, 3));
  geometry.setAttribute('normal', new BufferAttribute(mesh.normal, 3));
  geometry.setAttribute('blade', new BufferAttribute(mesh.blade, 4));
  geometry.setIndex(new BufferAttribute(mesh.index, 1));
  geometry.instanceCount = instances(count, bundle);
  Object.assign(geometry.userData, { count, triangles: mesh.trianglesPerCopy * count });
  return bounded(geometry, box);
}
