import { coverCount } from '../look/leaf-count.ts';
import { growthWidth, leafGrowth } from '../look/leaf-growth.ts';
import { type LeafGrain, type LeafSpec, leafMesh } from '../look/leaf-mesh.ts';
import { leafSpecOf } from '../look/leaf-shapes.ts';
import { bezierPoint, type Cubic } from '../math/bezier.ts';
import { type Handles, handlesOf, sectionFrame } from '../math/frames.ts';
import { hashPcg, hashUnit } from '../math/hash.ts';
import { writeQuaternion } from '../math/quaternion.ts';
import type { GrownPacked } from '../pack/grow-packed.ts';
import { leafTexel } from '../pack/leaf-texel.ts';
import { planeOf, poseOf } from '../wind/pose-plainly.ts';

/** One leaf as a mesh of its own: x across, y out of the upper face, z along, from the foot of the stalk; in metres. */
export interface LeafOutlineMesh {
  readonly position: Float32Array;
  readonly normal: Float32Array;
  /** Across (0..1, the midrib at 0.5) and along the blade (0..1, a stalk has 0); 2 a vertex. */
  readonly uv: Float32Array;
  readonly index: Uint16Array;
}

/** Where the leaves of a tree are: one leaf, placed many times. Tree space (z up), metres; nothing is scaled. */
export interface LeafPlacements {
  readonly leaf: LeafOutlineMesh;
  readonly count: number;
  /** Foot of the stalk; 3 a leaf. */
  readonly position: Float32Array;
  /** Rotation from the leaf's axes to tree space (x, y, z, w); 4 a leaf. */
  readonly quaternion: Float32Array;
  /** The piece that it hangs on, and the Bezier parameter there. */
  readonly piece: Uint32Array;
  readonly u: Float32Array;
  /** Phase of its motion in turns, and the number from which its colour is made, both 0..1. */
  readonly phase: Float32Array;
  readonly own: Float32Array;
}

export interface LeafPlacementOptions {
  readonly grain: LeafGrain;
  /** Leaves at most; those that stay are larger, so that they cover as much. Any number is spread evenly over the tree. */
  readonly most: number;
  /** Part of the leaves that is kept, likewise; 1 by default. */
  readonly share?: number;
  /** Leaves on stems of deeper levels are left out. */
  readonly levels: number;
  readonly pose?: Float32Array;
}

/** The leaves of a grown tree as they are drawn, or null where none is left. */
export function placeLeaves(grown: GrownPacked, options: LeafPlacementOptions): LeafPlacements | null {
  const { packed, tree } = grown;
  const { foliage } = tree.species;
  const spec = leafSpecOf(tree.species);
  const there = coverCount(packed.leafCount, foliage);
  const drawn = Math.min(Math.ceil((options.share ?? 1) * there), Math.max(0, Math.floor(options.most)));
  if (drawn === 0) return null;
  const [growX, growY] = leafGrowth(drawn / there, growthWidth(spec));
  const length = packed.leafLength * foliage.size;
  const placed = placeFirst(grown, drawn, options);
  const size = [growX * length, growY * length] as const;
  return placed && { leaf: outlineMesh(spec, options.grain, size), ...placed };
}

/** The first `drawn` places of the leaves' draw order, less those on stems that are left out; null where none is left. */
export function placeFirst(
  { packed, pieces }: GrownPacked,
  drawn: number,
  options: Pick<LeafPlacementOptions, 'levels' | 'pose'>,
): Omit<LeafPlacements, 'leaf'> | null {
  const pose = options.pose ?? packed.restPose.data;
  const plane = planeOf(packed.restPose);
  const position = new Float32Array(3 * drawn);
  const quaternion = new Float32Array(4 * drawn);
  const piece = new Uint32Array(drawn);
  const u = new Float32Array(drawn);
  const phase = new Float32Array(drawn);
  const own = new Float32Array(drawn);
  // Leaves of one piece are far apart in the draw order: its handles are made once.
  const known = new Map<number, { curve: Cubic; handles: Handles }>();
  const columns = new Float64Array(9);
  const q = new Float64Array(4);
  let count = 0;
  for (let place = 0; place < drawn; place++) {
    const texel = leafTexel(packed.leaves.data, place);
    if (pieces.level[texel.piece]! >= options.levels) continue;
    let at = known.get(texel.piece);
    if (!at) {
      const { curve, o } = poseOf(pose, plane, texel.piece);
      at = { curve, handles: handlesOf(curve, o) };
      known.set(texel.piece, at);
    }
    const frame = sectionFrame(at.curve, at.handles, texel.v);
    for (let k = 0; k < 9; k++) columns[k] = frame[Math.floor(k / 3)]![k % 3]!;
    writeQuaternion(columns, q, 0);
    writeProduct(q, texel.orientation, quaternion, 4 * count);
    position.set(bezierPoint(at.curve, texel.v), 3 * count);
    piece[count] = texel.piece;
    u[count] = texel.v;
    phase[count] = texel.phase;
    own[count] = hashUnit(hashPcg(Math.floor(texel.phase * 65535 + 0.5)));
    count++;
  }
  if (count === 0) return null;
  return {
    count,
    position: position.slice(0, 3 * count),
    quaternion: quaternion.slice(0, 4 * count),
    piece: piece.slice(0, count),
    u: u.slice(0, count),
    phase: phase.slice(0, count),
    own: own.slice(0, count),
  };
}

/** The unit leaf in metres; the stalk hides within the midrib of the image. */
function outlineMesh(spec: LeafSpec, grain: LeafGrain, [across, along]: readonly [number, number]): LeafOutlineMesh {
  const { position, normal, blade, index } = leafMesh(spec, grain, 1);
  const vertices = position.length / 3;
  const uv = new Float32Array(2 * vertices);
  const scaled = new Float32Array(position.length);
  const turned = new Float32Array(normal.length);
  for (let i = 0; i < vertices; i++) {
    const side = position[3 * i]! < 0 ? -1 : 1;
    uv[2 * i] = 0.5 + 0.5 * side * blade[4 * i]!;
    uv[2 * i + 1] = Math.min(1, Math.max(0, blade[4 * i + 1]!));
    scaled[3 * i] = position[3 * i]! * across;
    scaled[3 * i + 1] = position[3 * i + 1]! * along;
    scaled[3 * i + 2] = position[3 * i + 2]! * along;
    // Normals of a surface that is stretched across grow the other way.
    const nx = normal[3 * i]! / across;
    const ny = normal[3 * i + 1]! / along;
    const nz = normal[3 * i + 2]! / along;
    const n = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
    turned[3 * i] = nx * n;
    turned[3 * i + 1] = ny * n;
    turned[3 * i + 2] = nz * n;
  }
  return { position: scaled, normal: turned, uv, index: Uint16Array.from(index) };
}

/** Writes a b, of length 1, with w >= 0 so that equal rotations are equal numbers. */
function writeProduct(a: ArrayLike<number>, b: ArrayLike<number>, out: Float32Array, at: number): void {
  const x = a[3]! * b[0]! + a[0]! * b[3]! + a[1]! * b[2]! - a[2]! * b[1]!;
  const y = a[3]! * b[1]! - a[0]! * b[2]! + a[1]! * b[3]! + a[2]! * b[0]!;
  const z = a[3]! * b[2]! + a[0]! * b[1]! - a[1]! * b[0]! + a[2]! * b[3]!;
  const w = a[3]! * b[3]! - a[0]! * b[0]! - a[1]! * b[1]! - a[2]! * b[2]!;
  const n = (w < 0 ? -1 : 1) / Math.sqrt(x * x + y * y + z * z + w * w);
  out[at] = x * n;
  out[at + 1] = y * n;
  out[at + 2] = z * n;
  out[at + 3] = w * n;
}
