import { type HalfOutline, LEAF_SHAPES, type Leaflet, type LeafShape } from './leaf-outline.ts';
import { triangulate } from './triangulate.ts';

/** How finely a leaf is drawn. */
export type LeafGrain = 'near' | 'middle' | 'far';

/** Unit leaves, blade of length 1, bundled; petiole first, then the blade from z = petiole on. */
export interface LeafMesh {
  /** x across | y out of the upper face | z along, in lengths of the blade; 3 a vertex. */
  readonly position: Float32Array;
  /** Normal of the upper face; 3 a vertex. */
  readonly normal: Float32Array;
  /** distance from the midrib 0..1 | along the blade 0..1 (below 0 on the petiole) | copy within the bundle | 1 on the petiole; 4 a vertex. */
  readonly blade: Float32Array;
  readonly index: Uint16Array | Uint32Array;
  readonly verticesPerCopy: number;
  readonly trianglesPerCopy: number;
}

/** How far the halves lift from the midrib and how far the tip hangs, in lengths of the blade. */
const FOLD = 0.28;
const CURL = 0.16;

/** Half the width of a petiole at its foot, in lengths of the blade. */
const PETIOLE_WIDTH = 0.02;

const height = (x: number, z: number): number => FOLD * Math.abs(x) * (1 - 0.4 * z) - CURL * z * z;

function upNormal(x: number, z: number): [number, number, number] {
  // On the midrib the two halves share a vertex: their mean has no part across.
  const dx = Math.abs(x) < 1e-6 ? 0 : Math.sign(x) * FOLD * (1 - 0.4 * z);
  const dz = -0.4 * FOLD * Math.abs(x) - 2 * CURL * z;
  const n = Math.hypot(dx, 1, dz);
  return [-dx / n, 1 / n, -dz / n];
}

interface Builder {
  position: number[];
  normal: number[];
  blade: number[];
  index: number[];
}

/** Adds both halves of a leaflet; its midrib lies on the line from (x, z) at an angle. */
function addBlade(out: Builder, half: HalfOutline, width: number, petiole: number, ribs: number, place: Leaflet): void {
  const tip = half[half.length - 1] as readonly [number, number];
  const midrib: [number, number][] = [];
  for (let i = ribs; i >= 1; i--) midrib.push([0, (tip[1] * i) / (ribs + 1)]);
  const polygon = [...half, ...midrib];
  const triangles = triangulate(polygon);
  const c = Math.cos((place.turn * Math.PI) / 180);
  const s = Math.sin((place.turn * Math.PI) / 180);
  const left: number[] = [];
  const right: number[] = [];
  const vertex = (unit: number, z: number): number => {
    const x = unit * width;
    const [nx, ny, nz] = upNormal(x, z);
    const px = x * place.size;
    const pz = z * place.size;
    out.position.push(place.x + c * px + s * pz, height(x, z) * place.size, petiole + place.z - s * px + c * pz);
    out.normal.push(c * nx + s * nz, ny, -s * nx + c * nz);
    out.blade.push(Math.min(1, Math.abs(unit) * 2), z, 0, 0);
    return out.position.length / 3 - 1;
  };
  for (const [x, z] of polygon) {
    right.push(vertex(x, z));
    // The midrib is shared: a leaf is closed along it.
    left.push(Math.abs(x) < 1e-6 ? (right[right.length - 1] as number) : vertex(-x, z));
  }
  for (const triangle of triangles) {
    const [a, b, d] = triangle;
    const [pa, pb, pd] = [polygon[a], polygon[b], polygon[d]] as [[number, number], [number, number], [number, number]];
    // Seen from y > 0 with x to the right, z comes towards the eye: counter-clockwise there is clockwise in (x, z).
    const area = (pb[0] - pa[0]) * (pd[1] - pa[1]) - (pd[0] - pa[0]) * (pb[1] - pa[1]);
    const [f, g] = area > 0 ? [d, b] : [b, d];
    out.index.push(right[a] as number, right[f] as number, right[g] as number);
    out.index.push(left[a] as number, left[g] as number, left[f] as number);
  }
}

/** A thin triangle from the stem to the blade, widest at its foot. */
function addPetiole(out: Builder, petiole: number): void {
  const first = out.position.length / 3;
  for (const [x, z] of [
    [-PETIOLE_WIDTH, 0],
    [PETIOLE_WIDTH, 0],
    [0, petiole + 0.05],
  ] as const) {
    out.position.push(x, 0, z);
    out.normal.push(0, 1, 0);
    out.blade.push(0, z / petiole - 1, 0, 1);
  }
  out.index.push(first, first + 2, first + 1);
}

/** From afar, or where it is short, a petiole is not drawn. */
const hasPetiole = (petiole: number, grain: LeafGrain): boolean =>
  grain === 'near' ? petiole > 0 : grain === 'middle' && petiole > 0.15;

const RIBS = { near: 2, middle: 0, far: 0 } as const;

/** Triangles of one leaf. Throws RangeError for an unknown shape. */
export function leafTriangles(shape: number, petiole: number, grain: LeafGrain): number {
  const leaf = shapeOf(shape);
  const half = leaf[grain].length + RIBS[grain] - 2;
  return 2 * half * leaf.leaflets.length + (hasPetiole(petiole, grain) ? 1 : 0);
}

function shapeOf(shape: number): LeafShape {
  const leaf = LEAF_SHAPES[shape];
  if (!leaf) throw new RangeError(`leaf shape must be 0 to ${LEAF_SHAPES.length - 1}, found ${shape}`);
  return leaf;
}

/**
 * The mesh of one leaf shape, repeated `bundle` times.
 *
 * `shape` as in a species (0..5); `width` and `petiole` in lengths of the blade, > 0 and >= 0. Throws RangeError for an unknown shape.
 */
export function leafMesh(shape: number, width: number, petiole: number, grain: LeafGrain, bundle: number): LeafMesh {
  const leaf = shapeOf(shape);
  const one: Builder = { position: [], normal: [], blade: [], index: [] };
  if (hasPetiole(petiole, grain)) addPetiole(one, petiole);
  for (const place of leaf.leaflets) addBlade(one, leaf[grain], width, petiole, RIBS[grain], place);
  const verticesPerCopy = one.position.length / 3;
  const vertices = verticesPerCopy * bundle;
  const position = new Float32Array(vertices * 3);
  const normal = new Float32Array(vertices * 3);
  const blade = new Float32Array(vertices * 4);
  const index =
    vertices > 65535 ? new Uint32Array(one.index.length * bundle) : new Uint16Array(one.index.length * bundle);
  for (let copy = 0; copy < bundle; copy++) {
    position.set(one.position, copy * one.position.length);
    normal.set(one.normal, copy * one.normal.length);
    blade.set(one.blade, copy * one.blade.length);
    for (let i = 0; i < verticesPerCopy; i++) blade[(copy * verticesPerCopy + i) * 4 + 2] = copy;
    for (let i = 0; i < one.index.length; i++)
      index[copy * one.index.length + i] = (one.index[i] as number) + copy * verticesPerCopy;
  }
  return { position, normal, blade, index, verticesPerCopy, trianglesPerCopy: one.index.length / 3 };
}
