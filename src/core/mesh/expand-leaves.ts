import { rotateByQuaternion } from '../math/quaternion.ts';
import type { LeafPlacements } from './leaf-placements.ts';

/** Every leaf of a tree as triangles, in one mesh: metres, tree space (z up). */
export interface LeafTriangles {
  readonly vertexCount: number;
  readonly triangleCount: number;
  /** 3 a vertex. */
  readonly position: Float32Array;
  /** Of the upper face; 3 a vertex. */
  readonly normal: Float32Array;
  /** As LeafOutlineMesh has it; 2 a vertex. */
  readonly uv: Float32Array;
  /** The placement that each vertex comes from. */
  readonly leaf: Uint32Array;
  readonly index: Uint32Array;
}

/** Places the one leaf at each of its places. */
export function expandLeaves({ leaf, count, position, quaternion }: LeafPlacements): LeafTriangles {
  const each = leaf.position.length / 3;
  const vertices = each * count;
  const out = {
    vertexCount: vertices,
    triangleCount: (leaf.index.length / 3) * count,
    position: new Float32Array(3 * vertices),
    normal: new Float32Array(3 * vertices),
    uv: new Float32Array(2 * vertices),
    leaf: new Uint32Array(vertices),
    index: new Uint32Array(leaf.index.length * count),
  };
  for (let i = 0; i < count; i++) {
    // The rotation as nine numbers: nothing is allocated for a vertex.
    const q: [number, number, number, number] = [
      quaternion[4 * i]!,
      quaternion[4 * i + 1]!,
      quaternion[4 * i + 2]!,
      quaternion[4 * i + 3]!,
    ];
    const x = rotateByQuaternion(q, [1, 0, 0]);
    const y = rotateByQuaternion(q, [0, 1, 0]);
    const z = rotateByQuaternion(q, [0, 0, 1]);
    for (let k = 0; k < each; k++) {
      const to = i * each + k;
      const [a, b, c] = [leaf.position[3 * k]!, leaf.position[3 * k + 1]!, leaf.position[3 * k + 2]!];
      const [d, e, f] = [leaf.normal[3 * k]!, leaf.normal[3 * k + 1]!, leaf.normal[3 * k + 2]!];
      for (let n = 0; n < 3; n++) {
        out.position[3 * to + n] = position[3 * i + n]! + a * x[n]! + b * y[n]! + c * z[n]!;
        out.normal[3 * to + n] = d * x[n]! + e * y[n]! + f * z[n]!;
      }
      out.leaf[to] = i;
    }
    out.uv.set(leaf.uv, 2 * i * each);
    for (let k = 0; k < leaf.index.length; k++) out.index[i * leaf.index.length + k] = leaf.index[k]! + i * each;
  }
  return out;
}
