import type { Document, Primitive, TypedArray } from '@gltf-transform/core';
import { crownNormal } from '../../look/crown-normal.ts';
import type { BarkMesh } from '../../mesh/bark-mesh.ts';
import type { LeafTriangles } from '../../mesh/expand-leaves.ts';
import type { LeafPlacements } from '../../mesh/leaf-placements.ts';
import { INFLUENCES, type Skin } from '../../mesh/skin.ts';
import type { AccessorSize, Accessors } from './accessors.ts';
import type { TreeMaterials } from './materials.ts';
import { type Quantum, quantizeDirections, quantizePositions } from './quantize.ts';
import { yUp } from './y-up.ts';

/** One more attribute of every vertex of a mesh: `_BRANCH`, `COLOR_0` (which then takes the place of ours), `TEXCOORD_1`... */
export interface GlbAttribute {
  readonly semantic: string;
  readonly size: 1 | 2 | 3 | 4;
  readonly array: TypedArray;
  readonly normalized?: boolean;
}

/** What writes vertices: how, and what goes with all of them. */
export interface VertexWriter {
  readonly document: Document;
  readonly accessors: Accessors;
  readonly quantum: Quantum | null;
}

type Attributes = ReadonlyMap<string, { array: TypedArray; size: AccessorSize; normalized: boolean }>;

const setAll = (writer: VertexWriter, attributes: Attributes): ((primitive: Primitive) => Primitive) => {
  const made = [...attributes].map(([name, { array, size, normalized }]) => {
    return [name, writer.accessors.add(array, size, normalized)] as const;
  });
  return (primitive) => {
    for (const [name, accessor] of made) primitive.setAttribute(name, accessor);
    return primitive;
  };
};

/** Place and direction of vertices in y-up space, quantized where the writer is. */
function shape({ quantum }: VertexWriter, position: Float32Array, normal: Float32Array, tangent: Float32Array | null) {
  const attributes = new Map<string, { array: TypedArray; size: AccessorSize; normalized: boolean }>();
  const points = yUp(position);
  const normals = yUp(normal);
  const short = quantum !== null;
  attributes.set('POSITION', {
    array: quantum ? quantizePositions(points, quantum) : points,
    size: 3,
    normalized: short,
  });
  attributes.set('NORMAL', { array: short ? quantizeDirections(normals) : normals, size: 3, normalized: short });
  if (tangent) {
    const tangents = yUp(tangent, 4);
    attributes.set('TANGENT', { array: short ? quantizeDirections(tangents) : tangents, size: 4, normalized: short });
  }
  return attributes;
}

function addSkin(attributes: ReturnType<typeof shape>, skin: Skin | null, joints: number): void {
  if (!skin) return;
  const count = skin.joints.length / INFLUENCES;
  const ids = joints <= 256 ? new Uint8Array(4 * count) : new Uint16Array(4 * count);
  const weights = new Uint16Array(4 * count);
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < INFLUENCES; k++) {
      ids[4 * i + k] = skin.joints[INFLUENCES * i + k]!;
      weights[4 * i + k] = skin.weights[INFLUENCES * i + k]!;
    }
  }
  attributes.set('JOINTS_0', { array: ids, size: 4, normalized: false });
  attributes.set('WEIGHTS_0', { array: weights, size: 4, normalized: true });
}

function addMore(attributes: ReturnType<typeof shape>, more: readonly GlbAttribute[]): void {
  for (const { semantic, array, size, normalized = false } of more)
    attributes.set(semantic, { array, size, normalized });
}

/** The stems: a primitive for those with a pattern of bark and one for twigs, on the same vertices. */
export function barkPrimitives(
  writer: VertexWriter,
  mesh: BarkMesh,
  materials: TreeMaterials,
  tint: Uint8Array<ArrayBuffer>,
  skin: Skin | null,
  joints: number,
  more: readonly GlbAttribute[],
): Primitive[] {
  const attributes = shape(writer, mesh.position, mesh.normal, mesh.tangent);
  const uv = new Float32Array(mesh.uv.length);
  // glTF's images begin at the top.
  for (let i = 0; i < uv.length; i += 2) [uv[i], uv[i + 1]] = [mesh.uv[i]!, -mesh.uv[i + 1]!];
  attributes.set('TEXCOORD_0', { array: uv, size: 2, normalized: false });
  attributes.set('COLOR_0', { array: tint, size: 4, normalized: true });
  addSkin(attributes, skin, joints);
  addMore(attributes, more);
  const out: Primitive[] = [];
  for (const part of mesh.parts) {
    if (part.indexCount === 0) continue;
    // Of the part's own vertices alone: what a primitive does not draw it should not name.
    const { firstVertex: first, vertexCount: count } = part;
    const own = new Map(
      [...attributes].map(([name, a]) => [
        name,
        { ...a, array: slice(a.array, a.size * first, a.size * (first + count)) },
      ]),
    );
    if (part.name === 'twigs' || !materials.bark.getNormalTexture()) {
      own.delete('TANGENT');
      if (more.every(({ semantic }) => !semantic.startsWith('TEXCOORD'))) own.delete('TEXCOORD_0');
    }
    const index = mesh.index.subarray(part.firstIndex, part.firstIndex + part.indexCount);
    const primitive = setAll(writer, own)(writer.document.createPrimitive());
    out.push(
      primitive.setIndices(writer.accessors.add(indexOf(index, first, count), 1)).setMaterial(materials[part.name]),
    );
  }
  return out;
}

const slice = (array: TypedArray, from: number, to: number): TypedArray => array.slice(from, to) as TypedArray;

/** Indices less `first`, in two bytes where they fit; the last number of two bytes means a break. */
function indexOf(
  index: Uint32Array,
  first: number,
  vertices: number,
): Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer> {
  const out = vertices < 65535 ? new Uint16Array(index.length) : new Uint32Array(index.length);
  for (let i = 0; i < index.length; i++) out[i] = index[i]! - first;
  return out;
}

/** How far normals of leaves turn to the crown's outside, as the editor draws them. */
const ROUNDING = 0.5;

/**
 * Leaves as triangles. Their normals are turned towards the crown's outside, so that the crown reads as one body, on whichever side of the
 * leaf that is: a program that turns the normals of back faces around then lights both sides as it should.
 */
export function leafPrimitive(
  writer: VertexWriter,
  leaves: LeafTriangles,
  materials: TreeMaterials,
  tints: Float32Array,
  crown: ArrayLike<number>,
  skin: Skin | null,
  joints: number,
  more: readonly GlbAttribute[],
): Primitive {
  const { vertexCount, leaf, position } = leaves;
  const normal = leaves.normal.slice();
  const colour = new Uint8Array(4 * vertexCount).fill(255);
  const out = new Float64Array(3);
  for (let i = 0; i < vertexCount; i++) {
    for (let k = 0; k < 3; k++) colour[4 * i + k] = Math.round(255 * tints[3 * leaf[i]! + k]!);
    crownNormal(crown, position[3 * i]!, position[3 * i + 1]!, position[3 * i + 2]!, out);
    const [x, y, z] = [normal[3 * i]!, normal[3 * i + 1]!, normal[3 * i + 2]!];
    const side = x * out[0]! + y * out[1]! + z * out[2]! < 0 ? -ROUNDING : ROUNDING;
    const [nx, ny, nz] = [
      x * (1 - ROUNDING) + side * out[0]!,
      y * (1 - ROUNDING) + side * out[1]!,
      z * (1 - ROUNDING) + side * out[2]!,
    ];
    const n = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
    normal[3 * i] = nx * n;
    normal[3 * i + 1] = ny * n;
    normal[3 * i + 2] = nz * n;
  }
  const attributes = shape(writer, position, normal, null);
  if (materials.leaves.getBaseColorTexture() || more.some(({ semantic }) => semantic.startsWith('TEXCOORD'))) {
    attributes.set('TEXCOORD_0', { array: imagePlaces(leaves.uv), size: 2, normalized: false });
  }
  attributes.set('COLOR_0', { array: colour, size: 4, normalized: true });
  addSkin(attributes, skin, joints);
  addMore(attributes, more);
  return setAll(
    writer,
    attributes,
  )(writer.document.createPrimitive())
    .setIndices(writer.accessors.add(indexOf(leaves.index, 0, vertexCount), 1))
    .setMaterial(materials.leaves);
}

const imagePlaces = (uv: Float32Array): Float32Array<ArrayBuffer> => {
  const out = new Float32Array(uv.length);
  for (let i = 0; i < uv.length; i += 2) [out[i], out[i + 1]] = [uv[i]!, 1 - uv[i + 1]!];
  return out;
};

/** Organs as triangles; their normals are their own, since they are round. `colour`: 4 bytes a vertex. */
export function organPrimitive(
  writer: VertexWriter,
  { position, normal, index, vertexCount }: LeafTriangles,
  { organs }: TreeMaterials,
  colour: Uint8Array<ArrayBuffer>,
  skin: Skin | null,
  joints: number,
  more: readonly GlbAttribute[],
): Primitive {
  const attributes = shape(writer, position, normal, null);
  attributes.set('COLOR_0', { array: colour, size: 4, normalized: true });
  addSkin(attributes, skin, joints);
  addMore(attributes, more);
  return setAll(
    writer,
    attributes,
  )(writer.document.createPrimitive())
    .setIndices(writer.accessors.add(indexOf(index, 0, vertexCount), 1))
    .setMaterial(organs);
}

/** One organ, in its own axes, for instances. */
export const oneOrganPrimitive = (
  { document, accessors }: VertexWriter,
  { leaf }: LeafPlacements,
  { organs }: TreeMaterials,
  colour: Uint8Array<ArrayBuffer>,
): Primitive =>
  document
    .createPrimitive()
    .setAttribute('POSITION', accessors.add(leaf.position.slice(), 3))
    .setAttribute('NORMAL', accessors.add(leaf.normal.slice(), 3))
    .setAttribute('COLOR_0', accessors.add(colour, 4, true))
    .setIndices(accessors.add(leaf.index.slice(), 1))
    .setMaterial(organs);

/** One leaf, in its own axes, for instances. */
export function oneLeafPrimitive(writer: VertexWriter, { leaf }: LeafPlacements, materials: TreeMaterials): Primitive {
  const primitive = writer.document
    .createPrimitive()
    .setAttribute('POSITION', writer.accessors.add(leaf.position.slice(), 3))
    .setAttribute('NORMAL', writer.accessors.add(leaf.normal.slice(), 3))
    .setIndices(writer.accessors.add(leaf.index.slice(), 1))
    .setMaterial(materials.leaves);
  if (materials.leaves.getBaseColorTexture()) {
    primitive.setAttribute('TEXCOORD_0', writer.accessors.add(imagePlaces(leaf.uv), 2));
  }
  return primitive;
}
