import type { Document, Node, Skin } from '@gltf-transform/core';
import { localPlace } from '../../mesh/joint-clip.ts';
import { JOINT, type Skeleton } from '../../mesh/skeleton.ts';
import type { Accessors } from './accessors.ts';
import type { Quantum } from './quantize.ts';
import { yUpJoints } from './y-up.ts';

/** Nodes of the joints, the node that they stand under, and the skin of all. */
export interface SkinNodes {
  readonly root: Node;
  readonly joints: readonly Node[];
  readonly skin: Skin;
}

/** The joints as nodes at rest, and the skin that binds a mesh there; `rest`: JOINT numbers each, tree space. */
export function skinNodes(
  document: Document,
  accessors: Accessors,
  skeleton: Skeleton,
  rest: Float64Array,
  quantum: Quantum | null,
): SkinNodes {
  const places = yUpJoints(rest);
  const root = document.createNode('skeleton');
  const joints = skeleton.names.map((name) => document.createNode(name));
  const skin = document.createSkin('skeleton').setSkeleton(root);
  const inverse = new Float32Array(16 * skeleton.count);
  const local = new Float64Array(JOINT);
  for (let j = 0; j < skeleton.count; j++) {
    const parent = skeleton.parent[j]!;
    localPlace(places, JOINT * parent, parent, places, JOINT * j, local, 0);
    const node = joints[j]!;
    node.setTranslation([local[0]!, local[1]!, local[2]!]);
    node.setRotation([local[3]!, local[4]!, local[5]!, local[6]!]);
    (parent < 0 ? root : joints[parent]!).addChild(node);
    skin.addJoint(node);
    inverse.set(inverseOf(places, JOINT * j, quantum), 16 * j);
  }
  return {
    root,
    joints,
    skin: skin.setInverseBindMatrices(accessors.add(inverse, 16, false, 'inverse bind matrices')),
  };
}

/** The inverse of a rigid motion as a matrix by columns, of positions as they are stored. */
function inverseOf(joints: Float64Array, at: number, quantum: Quantum | null): number[] {
  const [px, py, pz, x, y, z, w] = joints.subarray(at, at + JOINT) as unknown as number[] as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  // Rows of the rotation are columns of its inverse.
  const r = [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ] as const;
  const [ox, oy, oz] = quantum ? quantum.offset : [0, 0, 0];
  const s = quantum ? quantum.scale : 1;
  const [dx, dy, dz] = [ox - px, oy - py, oz - pz];
  const moved = [0, 1, 2].map((k) => r[0][k]! * dx + r[1][k]! * dy + r[2][k]! * dz);
  return [
    ...[r[0], r[1], r[2]].flatMap((row) => [row[0] * s, row[1] * s, row[2] * s, 0]),
    moved[0]!,
    moved[1]!,
    moved[2]!,
    1,
  ];
}
