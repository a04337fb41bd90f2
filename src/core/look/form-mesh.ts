import type { Blade, BladeBend, LeafForm, MeshBuilder } from './blade.ts';
import type { LeafGrain } from './leaf-outline.ts';
import type { LeafSpec } from './leaf-spec.ts';
import { triangulate } from './triangulate.ts';

export type { MeshBuilder } from './blade.ts';
export type { LeafGrain } from './leaf-outline.ts';
export type { LeafSpec } from './leaf-spec.ts';

/** Unit leaves of length 1, bundled; petiole first, then the blades from z = petiole on. */
export interface LeafMesh {
  /** x across | y out of the upper face | z along, in lengths of the leaf; 3 a vertex. */
  readonly position: Float32Array;
  /** Normal of the upper face; 3 a vertex. */
  readonly normal: Float32Array;
  /** distance from the midrib 0..1 | along the blade 0..1 (below 0 on the petiole) | copy within the bundle | how near to the margin, 0..1, -1 on the petiole; 4 a vertex. */
  readonly blade: Float32Array;
  readonly index: Uint16Array | Uint32Array;
  readonly verticesPerCopy: number;
  readonly trianglesPerCopy: number;
}

/** Half the width of a petiole at its foot, in lengths of the blade. */
const PETIOLE_WIDTH = 0.02;

const height = ({ fold, arch, curl }: BladeBend, x: number, z: number): number =>
  fold * Math.abs(x) * (1 - 0.4 * z) - arch * x * x - curl * z * z;

function upNormal({ fold, arch, curl }: BladeBend, x: number, z: number): [number, number, number] {
  // On the midrib the two halves share a vertex: their mean has no part across.
  const dx = Math.abs(x) < 1e-6 ? 0 : Math.sign(x) * fold * (1 - 0.4 * z) - 2 * arch * x;
  const dz = -0.4 * fold * Math.abs(x) - 2 * curl * z;
  const n = Math.hypot(dx, 1, dz);
  return [-dx / n, 1 / n, -dz / n];
}

export const meshBuilder = (): MeshBuilder => ({ position: [], normal: [], blade: [], index: [] });

/** Adds both halves of a blade, as one triangle where its outline has two points. */
export function addBlade(
  out: MeshBuilder,
  { half, width, length, at, along, up, bend, ribs }: Blade,
  petiole: number,
): void {
  const tip = half[half.length - 1]!;
  const spike = half.length === 2;
  const midrib: [number, number][] = [];
  for (let i = ribs; i >= 1; i--) midrib.push([0, (tip[1] * i) / (ribs + 1)]);
  const polygon = [...half, ...midrib];
  const across = [
    up[1] * along[2] - up[2] * along[1],
    up[2] * along[0] - up[0] * along[2],
    up[0] * along[1] - up[1] * along[0],
  ];
  const left: number[] = [];
  const right: number[] = [];
  const vertex = (unit: number, z: number, margin: number): number => {
    const x = (unit * width) / length;
    const y = height(bend, x, z);
    const [nx, ny, nz] = upNormal(bend, x, z);
    for (const k of [0, 1, 2] as const) {
      const place = at[k] + length * (x * across[k]! + y * up[k] + z * along[k]);
      out.position.push(k === 2 ? petiole + place : place);
      out.normal.push(nx * across[k]! + ny * up[k] + nz * along[k]);
    }
    out.blade.push(Math.min(1, Math.abs(unit) * 2), z, 0, margin);
    return out.position.length / 3 - 1;
  };
  polygon.forEach(([x, z], i) => {
    const margin = i < half.length ? 1 : 0;
    right.push(vertex(x, z, margin));
    // The midrib is shared: a leaf is closed along it.
    left.push(Math.abs(x) < 1e-6 ? right[right.length - 1]! : vertex(-x, z, margin));
  });
  if (spike) {
    if (tip[0] === 0) out.index.push(right[1]!, right[0]!, left[0]!);
    else out.index.push(right[0]!, left[1]!, right[1]!);
    return;
  }
  for (const [a, b, d] of triangulate(polygon)) {
    const [pa, pb, pd] = [polygon[a]!, polygon[b]!, polygon[d]!];
    // Seen from y > 0 with x to the right, z comes towards the eye: counter-clockwise there is clockwise in (x, z).
    const area = (pb[0] - pa[0]) * (pd[1] - pa[1]) - (pd[0] - pa[0]) * (pb[1] - pa[1]);
    const [f, g] = area > 0 ? [d, b] : [b, d];
    out.index.push(right[a]!, right[f]!, right[g]!);
    out.index.push(left[a]!, left[g]!, left[f]!);
  }
}

/** A thin triangle from the stem to the blade, widest at its foot. */
function addPetiole(out: MeshBuilder, petiole: number, stalk = 0.05): void {
  const first = out.position.length / 3;
  for (const [x, z] of [
    [-PETIOLE_WIDTH, 0],
    [PETIOLE_WIDTH, 0],
    [0, petiole + stalk],
  ] as const) {
    out.position.push(x, 0, z);
    out.normal.push(0, 1, 0);
    out.blade.push(0, Math.min(0, z / petiole - 1), 0, -1);
  }
  out.index.push(first, first + 2, first + 1);
}

/** From afar, or where it is short, a petiole is not drawn. */
const hasPetiole = (petiole: number, grain: LeafGrain): boolean =>
  grain === 'near' ? petiole > 0 : grain === 'middle' && petiole > 0.15;

/** Size of a leaf whose form is given. */
type FormSize = Pick<LeafSpec, 'width' | 'petiole'>;

/** Triangles of one leaf of a form; `sessile`: without its petiole. */
export function formTriangles(form: LeafForm, { width, petiole }: FormSize, grain: LeafGrain, sessile = false): number {
  const blades = form.blades(width, grain);
  const all = blades.reduce(
    (sum, { half, ribs }) => sum + (half.length === 2 ? 1 : 2 * (half.length + ribs - 2)),
    form.teeth?.(width, grain)?.triangles ?? 0,
  );
  return all + (!sessile && hasPetiole(petiole, grain) ? 1 : 0);
}

/** The mesh of one leaf of a form, repeated `bundle` times; `sessile`: without its petiole, which leaves a gap for it. */
export function formMesh(
  form: LeafForm,
  { width, petiole }: FormSize,
  grain: LeafGrain,
  bundle: number,
  sessile = false,
): LeafMesh {
  const one = meshBuilder();
  if (!sessile && hasPetiole(petiole, grain)) addPetiole(one, petiole, form.stalk);
  for (const blade of form.blades(width, grain)) addBlade(one, blade, petiole);
  form.teeth?.(width, grain)?.add(one, petiole);
  return bundled(one, bundle);
}

/** A mesh, repeated. */
export function bundled(one: MeshBuilder, bundle: number): LeafMesh {
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
      index[copy * one.index.length + i] = one.index[i]! + copy * verticesPerCopy;
  }
  return { position, normal, blade, index, verticesPerCopy, trianglesPerCopy: one.index.length / 3 };
}
