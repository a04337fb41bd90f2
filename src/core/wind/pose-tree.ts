import { arcOfProducts, type Cubic } from '../math/bezier.ts';
import { across, type Handles, handlesOf } from '../math/frames.ts';
import { PIECE_LAYERS, POSE_TARGETS } from '../pack/layout.ts';
import { FOLD } from './bend.ts';
import { type PiecesToPose, planeOf, poseOf, poseTreePlainly } from './pose-plainly.ts';
import type { Bends, WindToPose } from './push.ts';
import { PushWriter } from './push-writer.ts';

/**
 * The pose of every piece of a tree in a wind, laid out as `restPose`: what the wind pass computes, on the CPU.
 *
 * `exact` poses parents before their children. `lagged` takes every parent from `previous`, the pose of the last step (the rest
 * pose by default), as the paper does; `out` must then be another array. `bends` is what the models `spring` and `sway` need. Numbers
 * are written out so that hardly anything is allocated for a piece; a test holds it to `poseTreePlainly`.
 * Source: Skjermo 2007, 4.2 and equation 17.
 */
export function poseTree(
  tree: PiecesToPose,
  wind: WindToPose,
  mode: 'exact' | 'lagged',
  previous: Float32Array = tree.restPose.data,
  out: Float32Array = new Float32Array(tree.restPose.data.length),
  bends: Bends = {},
): Float32Array {
  // The printed forms are for teaching: no second fast version of them.
  if (wind.paper) return poseTreePlainly(tree, wind, mode, previous, out, bends);
  const { data } = tree.pieces;
  const plane = planeOf(tree.pieces);
  const posePlane = planeOf(tree.restPose);
  const attach = PIECE_LAYERS.ATTACH * plane;
  const parents = mode === 'lagged' ? previous : out;
  const section = new Float64Array(12);
  const pushes = new PushWriter(tree.pieces, wind, bends);
  let lastParent = -2;
  let curve: Cubic | undefined;
  let handles: Handles | undefined;
  for (let i = 0; i < tree.pieceCount; i++) {
    const parent = data[attach + 4 * i];
    // Siblings are neighbours: the parent's handles serve them all.
    if (parent >= 0 && parent !== lastParent) {
      const pose = poseOf(parents, posePlane, parent);
      curve = pose.curve;
      handles = handlesOf(curve, pose.o);
      lastParent = parent;
    }
    if (parent < 0 || curve === undefined || handles === undefined) rootSection(previous, 4 * i, section);
    else sectionAt(curve, handles, data[attach + 4 * i + 1], section);
    posePiece(data, plane, 4 * i, section, pushes, out, posePlane);
  }
  return out;
}

/** Where a root stands, with the axes of tree space. */
function rootSection(pose: Float32Array, at: number, out: Float64Array): void {
  out.fill(0);
  out[0] = pose[at];
  out[1] = pose[at + 1];
  out[2] = pose[at + 2];
  out[3] = out[7] = out[11] = 1;
}

/** C(v), U, T^, S^ of a curve, as `sectionFrame` gives them: 12 numbers. */
function sectionAt({ p0, p1, p2, p3 }: Cubic, h: Handles, v: number, out: Float64Array): void {
  const u = 1 - v;
  const [b0, b1, b2, b3] = [u * u * u, 3 * u * u * v, 3 * u * v * v, v * v * v];
  const [q0, q1, q2] = [u * u, 2 * u * v, v * v];
  let dd = 0;
  let chord = 0;
  for (let k = 0; k < 3; k++) {
    out[k] = b0 * p0[k] + b1 * p1[k] + b2 * p2[k] + b3 * p3[k];
    const d = 3 * (q0 * (p1[k] - p0[k]) + q1 * (p2[k] - p1[k]) + q2 * (p3[k] - p2[k]));
    out[3 + k] = d;
    dd += d * d;
    chord += (p3[k] - p0[k]) * (p3[k] - p0[k]);
    out[6 + k] = q0 * h.t0[k] + q1 * h.t1[k] + q2 * h.t2[k];
  }
  if (!(dd > 1e-12 * chord) || dd < 1e-24) {
    // The tangent vanishes: the chord stands in, and for a point the first edge.
    for (let k = 0; k < 3; k++) out[3 + k] = chord < 1e-24 ? h.l0[k] : p3[k] - p0[k];
    dd = chord < 1e-24 ? 1 : chord;
  }
  const s = 1 / Math.sqrt(dd);
  const ux = out[3] * s;
  const uy = out[4] * s;
  const uz = out[5] * s;
  const along = ux * out[6] + uy * out[7] + uz * out[8];
  const tx = out[6] - along * ux;
  const ty = out[7] - along * uy;
  const tz = out[8] - along * uz;
  const tt = tx * tx + ty * ty + tz * tz;
  const steady = tt > 1e-6 * (tt + along * along);
  const r = 1 / Math.sqrt(tt);
  const t = steady ? undefined : across([ux, uy, uz], [out[6], out[7], out[8]]);
  out[3] = ux;
  out[4] = uy;
  out[5] = uz;
  out[6] = t ? t[0] : tx * r;
  out[7] = t ? t[1] : ty * r;
  out[8] = t ? t[2] : tz * r;
  out[9] = uy * out[8] - uz * out[7];
  out[10] = uz * out[6] - ux * out[8];
  out[11] = ux * out[7] - uy * out[6];
}

const baseFrame = new Float64Array(9);

/** Attaches the piece whose texels start at `at` to a section, bends it and writes its pose. */
function posePiece(
  data: Float32Array,
  plane: number,
  at: number,
  section: Float64Array,
  pushes: PushWriter,
  out: Float32Array,
  posePlane: number,
): void {
  const orient = PIECE_LAYERS.ORIENT * plane + at;
  const handle = PIECE_LAYERS.HANDLE * plane + at;
  const end = PIECE_LAYERS.END * plane + at;
  // Base frame in tree space: the section times the rotation of the quaternion.
  const x = data[orient];
  const y = data[orient + 1];
  const z = data[orient + 2];
  const w = data[orient + 3];
  const [m00, m01, m02] = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
  const [m10, m11, m12] = [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
  const [m20, m21, m22] = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
  const cx = section[0];
  const cy = section[1];
  const cz = section[2];
  const ux = section[3];
  const uy = section[4];
  const uz = section[5];
  const tx = section[6];
  const ty = section[7];
  const tz = section[8];
  const sx = section[9];
  const sy = section[10];
  const sz = section[11];
  const lx = ux * m00 + tx * m01 + sx * m02;
  const ly = uy * m00 + ty * m01 + sy * m02;
  const lz = uz * m00 + tz * m01 + sz * m02;
  const ox = ux * m10 + tx * m11 + sx * m12;
  const oy = uy * m10 + ty * m11 + sy * m12;
  const oz = uz * m10 + tz * m11 + sz * m12;
  const nx = ux * m20 + tx * m21 + sx * m22;
  const ny = uy * m20 + ty * m21 + sy * m22;
  const nz = uz * m20 + tz * m21 + sz * m22;
  // Edges in tree space, from the control points in the base frame.
  const p1 = data[handle + 3];
  let [ex, ey, ez] = [data[handle] - p1, data[handle + 1], data[handle + 2]];
  const e2x = lx * ex + ox * ey + nx * ez;
  const e2y = ly * ex + oy * ey + ny * ez;
  const e2z = lz * ex + oz * ey + nz * ez;
  [ex, ey, ez] = [data[end] - data[handle], data[end + 1] - data[handle + 1], data[end + 2] - data[handle + 2]];
  const e3x = lx * ex + ox * ey + nx * ez;
  const e3y = ly * ex + oy * ey + ny * ez;
  const e3z = lz * ex + oz * ey + nz * ez;
  baseFrame[0] = lx;
  baseFrame[1] = ly;
  baseFrame[2] = lz;
  baseFrame[3] = ox;
  baseFrame[4] = oy;
  baseFrame[5] = oz;
  baseFrame[6] = nx;
  baseFrame[7] = ny;
  baseFrame[8] = nz;
  pushes.write(at, baseFrame);
  const { push } = pushes;
  // Bend: both edges lean and keep their lengths (`leanPiece`), and the piece keeps its own.
  const fold2 = leastCosine(lx, ly, lz, e2x, e2y, e2z);
  const fold3 = leastCosine(e2x, e2y, e2z, e3x, e3y, e3z);
  leanEdge(e2x, e2y, e2z, push[0], push[1], push[2]);
  unfoldEdge(lx * p1, ly * p1, lz * p1, fold2);
  const [bx, by, bz] = [edge[0], edge[1], edge[2]];
  leanEdge(e3x, e3y, e3z, push[3], push[4], push[5]);
  unfoldEdge(bx, by, bz, fold3);
  const [dx, dy, dz] = [edge[0], edge[1], edge[2]];
  const arc = arcOfProducts(
    p1 * p1,
    p1 * (lx * bx + ly * by + lz * bz),
    p1 * (lx * dx + ly * dy + lz * dz),
    bx * bx + by * by + bz * bz,
    bx * dx + by * dy + bz * dz,
    dx * dx + dy * dy + dz * dz,
  );
  const s = arc > 0 ? data[end + 3] / arc : 1;
  const q1x = lx * p1 * s;
  const q1y = ly * p1 * s;
  const q1z = lz * p1 * s;
  const q2x = q1x + bx * s;
  const q2y = q1y + by * s;
  const q2z = q1z + bz * s;
  let o = POSE_TARGETS.P0 * posePlane + at;
  out[o] = cx;
  out[o + 1] = cy;
  out[o + 2] = cz;
  out[o + 3] = ox;
  o = POSE_TARGETS.P1 * posePlane + at;
  out[o] = cx + q1x;
  out[o + 1] = cy + q1y;
  out[o + 2] = cz + q1z;
  out[o + 3] = oy;
  o = POSE_TARGETS.P2 * posePlane + at;
  out[o] = cx + q2x;
  out[o + 1] = cy + q2y;
  out[o + 2] = cz + q2z;
  out[o + 3] = oz;
  o = POSE_TARGETS.P3 * posePlane + at;
  out[o] = cx + q2x + dx * s;
  out[o + 1] = cy + q2y + dy * s;
  out[o + 2] = cz + q2z + dz * s;
  out[o + 3] = push[6];
}

const edge = new Float64Array(3);

/** `leanEdge` into `edge`. */
function leanEdge(ex: number, ey: number, ez: number, px: number, py: number, pz: number): void {
  const l = Math.sqrt(ex * ex + ey * ey + ez * ez);
  const keep = 1 - Math.min((ex * px + ey * py + ez * pz) / Math.max(l, 1e-30), 0);
  const x = keep * ex + l * px;
  const y = keep * ey + l * py;
  const z = keep * ez + l * pz;
  const s = l / Math.max(Math.sqrt(x * x + y * y + z * z), 1e-30);
  edge[0] = x * s;
  edge[1] = y * s;
  edge[2] = z * s;
}

/** The least cosine that two edges may have in the wind, from those at rest. */
const leastCosine = (ax: number, ay: number, az: number, bx: number, by: number, bz: number): number => {
  const ab = ax * bx + ay * by + az * bz;
  if (ab >= 0) return FOLD;
  const lengths = (ax * ax + ay * ay + az * az) * (bx * bx + by * by + bz * bz);
  return Math.min(ab / Math.sqrt(Math.max(lengths, 1e-36)), FOLD);
};

/** `unfoldEdge` of `edge`, which follows (ax, ay, az). */
function unfoldEdge(ax: number, ay: number, az: number, least: number): void {
  const bx = edge[0];
  const by = edge[1];
  const bz = edge[2];
  const ab = ax * bx + ay * by + az * bz;
  if (ab >= 0) return;
  const aa = Math.max(ax * ax + ay * ay + az * az, 1e-30);
  const bb = bx * bx + by * by + bz * bz;
  const c = ab / Math.sqrt(Math.max(aa * bb, 1e-36));
  if (c >= least) return;
  const k = least * Math.sqrt(bb / aa);
  const aside = Math.sqrt((1 - least * least) / Math.max(1 - c * c, 1e-3));
  edge[0] = k * ax + aside * (bx - (ax * ab) / aa);
  edge[1] = k * ay + aside * (by - (ay * ab) / aa);
  edge[2] = k * az + aside * (bz - (az * ab) / aa);
}

export {
  type PiecesToPose,
  planeOf,
  poseOf,
  poseTreePlainly,
  restPieceOf,
  writePose,
} from './pose-plainly.ts';
export type { Bends, WindToPose } from './push.ts';
