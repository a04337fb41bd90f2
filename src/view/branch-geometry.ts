import { type Box3, BufferAttribute, InstancedBufferGeometry, Sphere } from 'three';
import type { LeafMesh } from '../core/look/leaf-mesh.ts';
import { type Copies, type Forms, joined } from './coarse-shadow.ts';
import { branchGrid, type Grid, type GridSpec } from './grid.ts';

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

/** Draws other pieces or leaves with the same copies: `count` of them within `box`, and `cast` of them into shadow maps. */
export function recount(
  geometry: InstancedBufferGeometry,
  count: number,
  bundle: number,
  box: Box3,
  cast = count,
): void {
  const { userData } = geometry;
  userData.triangles = (userData.triangles / userData.count) * count;
  userData.count = count;
  geometry.instanceCount = instances(count, bundle);
  const forms = userData.forms as Forms | undefined;
  if (forms) {
    forms.instances = geometry.instanceCount;
    forms.shadow.instances = instances(cast, bundle);
  }
  bounded(geometry, box);
}

const gridCopies = ({ position, shape, index, verticesPerCopy }: Grid, bundle: number): Copies => ({
  attributes: { position, normal: shape },
  index,
  vertices: verticesPerCopy * bundle,
});

const leafCopies = ({ position, normal, blade, index }: LeafMesh): Copies => ({
  attributes: { position, normal, blade },
  index,
  vertices: position.length / 3,
});

/** Instanced geometry of `count` copies, `triangles` each; `shadow`: what `cast` of them are in shadow maps. */
function geometryOf(
  picture: Copies,
  shadow: Copies | null,
  [count, cast, bundle, triangles]: readonly [count: number, cast: number, bundle: number, triangles: number],
): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  const { attributes, index, vertices } = shadow ? joined(picture, shadow) : picture;
  for (const [name, array] of Object.entries(attributes)) {
    geometry.setAttribute(name, new BufferAttribute(array, array.length / vertices));
  }
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.instanceCount = instances(count, bundle);
  Object.assign(geometry.userData, { count, triangles: triangles * count });
  if (!shadow) return geometry;
  const indices = picture.index.length;
  const forms: Forms = {
    indices,
    instances: geometry.instanceCount,
    shadow: { first: indices, indices: shadow.index.length, instances: instances(cast, bundle) },
  };
  geometry.userData.forms = forms;
  geometry.setDrawRange(0, indices);
  return geometry;
}

/** A grid as instanced geometry over `count` pieces; `box` bounds them in tree space; `shadow`: its bands as a ribbon in shadow maps, 0 for the grid itself. */
export function branchGeometry(spec: GridSpec, count: number, box: Box3, shadow = 0): InstancedBufferGeometry {
  const grid = branchGrid(spec);
  const { bundle } = spec;
  const ribbon = shadow > 0 ? gridCopies(branchGrid({ ...spec, sectors: 1, bands: shadow, cap: false }), bundle) : null;
  return bounded(geometryOf(gridCopies(grid, bundle), ribbon, [count, count, bundle, grid.trianglesPerCopy]), box);
}

/** What leaves are in shadow maps: another mesh of as many copies, and how many of them. */
export interface LeafShadow {
  readonly mesh: LeafMesh;
  readonly count: number;
}

/** Leaves, `bundle` copies a mesh, as instanced geometry over `count` of them; `box` bounds them in tree space. */
export function leafGeometry(
  mesh: LeafMesh,
  count: number,
  bundle: number,
  box: Box3,
  shadow: LeafShadow | null = null,
): InstancedBufferGeometry {
  const numbers = [count, shadow?.count ?? count, bundle, mesh.trianglesPerCopy] as const;
  return bounded(geometryOf(leafCopies(mesh), shadow && leafCopies(shadow.mesh), numbers), box);
}
