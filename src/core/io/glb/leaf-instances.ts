import type { Document, Mesh, Node } from '@gltf-transform/core';
import { EXTMeshGPUInstancing } from '@gltf-transform/extensions';
import { relativeRotation, turned } from '../../mesh/joint-math.ts';
import type { LeafPlacements } from '../../mesh/leaf-placements.ts';
import { JOINT, type Skeleton } from '../../mesh/skeleton.ts';
import { heaviest, type Skin } from '../../mesh/skin.ts';
import type { Accessors } from './accessors.ts';
import { yUp, yUpRotations } from './y-up.ts';

/** A node that draws a mesh at each of some places. `which`: the leaves, all by default. */
function instanceNode(
  document: Document,
  accessors: Accessors,
  name: string,
  mesh: Mesh,
  position: Float32Array,
  rotation: Float32Array,
  tints: Float32Array,
): Node {
  const instances = document
    .createExtension(EXTMeshGPUInstancing)
    .createInstancedMesh()
    .setAttribute('TRANSLATION', accessors.add(position, 3))
    .setAttribute('ROTATION', accessors.add(rotation, 4))
    .setAttribute('_COLOR_0', accessors.add(tints, 3));
  return document.createNode(name).setMesh(mesh).setExtension('EXT_mesh_gpu_instancing', instances);
}

/** All leaves under one node, y up. `tints`: 3 a leaf. */
export const leafNode = (
  document: Document,
  accessors: Accessors,
  name: string,
  mesh: Mesh,
  { position, quaternion }: LeafPlacements,
  tints: Float32Array,
): Node => instanceNode(document, accessors, name, mesh, yUp(position), yUpRotations(quaternion), tints.slice());

/**
 * Hangs the leaves under the joint that has more of a say where each grows: a node with instances for each joint that bears any. `rest`:
 * the joints at rest, y up.
 */
export function hangLeaves(
  document: Document,
  accessors: Accessors,
  name: string,
  mesh: Mesh,
  leaves: LeafPlacements,
  tints: Float32Array,
  skeleton: Skeleton,
  skin: Skin,
  rest: Float64Array,
  joints: readonly Node[],
): void {
  const borne = Array.from({ length: skeleton.count }, () => [] as number[]);
  for (let i = 0; i < leaves.count; i++) borne[heaviest(skin, i)]!.push(i);
  const positions = Float64Array.from(yUp(leaves.position));
  const rotations = yUpRotations(Float64Array.from(leaves.quaternion));
  const place = new Float64Array(3);
  const turn = new Float64Array(4);
  borne.forEach((list, j) => {
    if (list.length === 0) return;
    const at = JOINT * j;
    const position = new Float32Array(3 * list.length);
    const rotation = new Float32Array(4 * list.length);
    const colours = new Float32Array(3 * list.length);
    list.forEach((i, n) => {
      const [x, y, z] = [0, 1, 2].map((k) => positions[3 * i + k]! - rest[at + k]!) as [number, number, number];
      turned(rest, at + 3, -1, x, y, z, place, 0);
      relativeRotation(rest, at + 3, rotations, 4 * i, turn, 0);
      position.set(place, 3 * n);
      rotation.set(turn, 4 * n);
      colours.set(tints.subarray(3 * i, 3 * i + 3), 3 * n);
    });
    const node = instanceNode(document, accessors, `${name}_${skeleton.names[j]!}`, mesh, position, rotation, colours);
    joints[j]!.addChild(node);
  });
}
