import { type Box3, BufferAttribute, InstancedBufferGeometry, Sphere } from 'three';
import type { LeafMesh } from '../core/look/leaf-mesh.ts';

function bounded(geometry: InstancedBufferGeometry, box: Box3): InstancedBufferGeometry {
  geometry.boundingBox = box.clone();
  geometry.boundingSphere = box.getBoundingSphere(new Sphere());
  return geometry;
}

/** Lines along pieces, `bundle` pieces an instance, as the deformer's grid reads them: the axis of a ribbon. */
export function lineGeometry(segments: number, bundle: number, box: Box3): InstancedBufferGeometry {
  const position: number[] = [];
  const shape: number[] = [];
  const index: number[] = [];
  for (let copy = 0; copy < bundle; copy++) {
    for (let row = 0; row <= segments; row++) {
      if (row > 0) index.push(position.length / 3 - 1, position.length / 3);
      position.push(0, 0, row / segments);
      shape.push(0.5, copy, 0);
    }
  }
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(shape), 3));
  geometry.setIndex(index);
  return bounded(geometry, box);
}

/** The blade of a leaf: its area in squares of its length, its middle, and a normal there. */
export interface BladeMiddle {
  readonly area: number;
  readonly middle: readonly [number, number, number];
}

/** Measures the first copy of a leaf's mesh. */
export function bladeMiddle({ position, index, verticesPerCopy }: LeafMesh): BladeMiddle {
  const middle: [number, number, number] = [0, 0, 0];
  let area = 0;
  for (let i = 0; i < index.length; i += 3) {
    const corners = [0, 1, 2].map((k) => (index[i + k] as number) * 3);
    if (corners.some((c) => c >= verticesPerCopy * 3)) break;
    const [a, b, c] = corners.map((at) => position.subarray(at, at + 3)) as [Float32Array, Float32Array, Float32Array];
    const u = [0, 1, 2].map((k) => (b[k] as number) - (a[k] as number)) as [number, number, number];
    const v = [0, 1, 2].map((k) => (c[k] as number) - (a[k] as number)) as [number, number, number];
    const part = 0.5 * Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    for (const k of [0, 1, 2] as const)
      middle[k] += (part * ((a[k] as number) + (b[k] as number) + (c[k] as number))) / 3;
    area += part;
  }
  const scale = area > 0 ? 1 / area : 0;
  return { area, middle: [middle[0] * scale, middle[1] * scale, middle[2] * scale] };
}

/** Leaves as points, `bundle` an instance. */
export function pointGeometry({ middle }: BladeMiddle, bundle: number, box: Box3): InstancedBufferGeometry {
  const position: number[] = [];
  const normal: number[] = [];
  const blade: number[] = [];
  for (let copy = 0; copy < bundle; copy++) {
    position.push(...middle);
    normal.push(0, 1, 0);
    blade.push(0.5, 0.5, copy, 0.4);
  }
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(normal), 3));
  geometry.setAttribute('blade', new BufferAttribute(new Float32Array(blade), 4));
  return bounded(geometry, box);
}
