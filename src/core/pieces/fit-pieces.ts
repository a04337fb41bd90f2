import type { Tree } from '../grow/tree.ts';
import { writeColumns } from '../math/columns.ts';
import { writeQuaternion } from '../math/quaternion.ts';
import { type Chains, fitChains } from './chain.ts';
import {
  RECORD,
  recordArc,
  recordFrame,
  recordLength,
  recordParameter,
  recordPoint,
  transportRecord,
} from './curve.ts';
import { orderPieces, type PieceOrder } from './order.ts';
import type { Pieces } from './pieces.ts';

/**
 * Turns the stems of a tree into cubic Bezier pieces that hang on each other (equations.md, sections 4 and 7).
 *
 * Stems keep their orientation in tree space and move as a whole to where their parent's curve runs. Computed in double,
 * depth by depth, from the values as they are stored, so that posing the result gives the rest pose back to float
 * precision.
 */
export function fitPieces(tree: Tree): Pieces {
  const chains = fitChains(tree);
  const { stems } = tree;
  const parent = new Int32Array(chains.count);
  for (let i = 0; i < stems.count; i++) {
    const first = chains.start[i];
    parent[first] = stems.parent[i] < 0 ? -1 : pieceAt(chains, stems.parent[i], stems.parentZ[i]);
    for (let k = first + 1; k < chains.start[i + 1]; k++) parent[k] = k - 1;
  }
  return place(tree, chains, parent, orderPieces(parent));
}

/** The piece of a stem that covers z; at a joint the one that ends there, which is less deep. */
function pieceAt({ start, span }: Chains, stem: number, z: number): number {
  let k = start[stem];
  const last = start[stem + 1] - 1;
  while (k < last && z > span[2 * k + 1]) k++;
  return k;
}

function place(tree: Tree, chains: Chains, parentOf: Int32Array, order: PieceOrder): Pieces {
  const { stems } = tree;
  const { count } = chains;
  const { place: placeOf, depth: depthOf, maxDepth, depthStart } = order;
  const pieces = {
    count,
    maxDepth,
    depthStart,
    depth: new Uint16Array(count),
    stem: new Int32Array(count),
    level: new Uint8Array(count),
    parent: new Int32Array(count),
    v: new Float32Array(count),
    orientation: new Float32Array(4 * count),
    rootPosition: new Float32Array(3 * depthStart[1]),
    local: new Float32Array(7 * count),
    control: new Float32Array(12 * count),
    orient: new Float32Array(3 * count),
    arc: new Float32Array(count),
    span: new Float32Array(2 * count),
    firstOfStem: new Int32Array(stems.count),
    next: new Int32Array(count).fill(-1),
    deviation: chains.deviation,
  } satisfies Pieces;
  // Parents stand before their children in the order of the stems too: one walk places everything.
  const record = new Float64Array(RECORD * count);
  const arcs = new Float64Array(count);
  const point = new Float64Array(3);
  const frame = new Float64Array(9);
  const base = new Float64Array(9);
  const turn = new Float64Array(9);
  const quaternion = new Float64Array(4);
  for (let stem = 0; stem < stems.count; stem++) {
    pieces.firstOfStem[stem] = placeOf[chains.start[stem]];
    for (let i = chains.start[stem]; i < chains.start[stem + 1]; i++) {
      const chained = i > chains.start[stem];
      const above = parentOf[i];
      const at = RECORD * i;
      const to = placeOf[i];
      const o = 9 * i;
      const c = chains.offset;
      let v = 0;
      if (chained) {
        v = 1;
        for (let k = 0; k < 3; k++) {
          point[k] = record[RECORD * above + 9 + k];
          record[at + 12 + k] = record[RECORD * above + 18 + k];
        }
        pieces.next[placeOf[above]] = to;
      } else {
        const node = stems.nodeStart[stem];
        for (let k = 0; k < 3; k++) record[at + 12 + k] = stems.nodeFrame[9 * node + 3 + k];
        if (above < 0) for (let k = 0; k < 3; k++) point[k] = Math.fround(stems.nodePosition[3 * node + k]);
        else {
          const z0 = chains.span[2 * above];
          const z1 = chains.span[2 * above + 1];
          const part = (stems.parentZ[stem] - z0) / (z1 - z0);
          v = Math.fround(recordParameter(record, RECORD * above, part, arcs[above]));
          recordPoint(record, RECORD * above, v, point);
        }
      }
      for (let k = 0; k < 3; k++) {
        record[at + k] = point[k];
        record[at + 3 + k] = point[k] + c[o + k];
        record[at + 6 + k] = point[k] + c[o + 3 + k];
        record[at + 9 + k] = point[k] + c[o + 6 + k];
      }
      transportRecord(record, at);
      arcs[i] = recordArc(record, at, 1);
      const edge = baseFrame(record, at, c, o, base);
      if (chained) identity(quaternion);
      else if (above < 0) writeQuaternion(base, quaternion, 0);
      else {
        recordFrame(record, RECORD * above, v, frame);
        relative(frame, base, turn);
        writeQuaternion(turn, quaternion, 0);
      }
      pieces.depth[to] = depthOf[i];
      pieces.stem[to] = stem;
      pieces.level[to] = stems.level[stem];
      pieces.parent[to] = above < 0 ? -1 : placeOf[above];
      pieces.v[to] = v;
      pieces.arc[to] = recordLength(record, at);
      pieces.span[2 * to] = chains.span[2 * i];
      pieces.span[2 * to + 1] = chains.span[2 * i + 1];
      for (let k = 0; k < 4; k++) pieces.orientation[4 * to + k] = quaternion[k];
      for (let k = 0; k < 12; k++) pieces.control[12 * to + k] = record[at + k];
      for (let k = 0; k < 3; k++) {
        pieces.orient[3 * to + k] = record[at + 12 + k];
        pieces.local[7 * to + 1 + k] = along(base, 3 * k, c, o + 3);
        pieces.local[7 * to + 4 + k] = along(base, 3 * k, c, o + 6);
        if (above < 0) pieces.rootPosition[3 * to + k] = point[k];
      }
      pieces.local[7 * to] = edge;
    }
  }
  return pieces;
}

/** Writes the base frame (L, T, S = L x T) of a record as columns; returns the length of its first edge. */
function baseFrame(record: Float64Array, at: number, c: Float64Array, o: number, out: Float64Array): number {
  const edge = Math.sqrt(c[o] * c[o] + c[o + 1] * c[o + 1] + c[o + 2] * c[o + 2]);
  const lx = c[o] / edge;
  const ly = c[o + 1] / edge;
  const lz = c[o + 2] / edge;
  writeColumns(out, lx, ly, lz, record[at + 12], record[at + 13], record[at + 14]);
  return edge;
}

/** out = a^T b, all three as columns. */
function relative(a: Float64Array, b: Float64Array, out: Float64Array): void {
  for (let j = 0; j < 9; j += 3) {
    for (let i = 0; i < 3; i++) out[j + i] = a[3 * i] * b[j] + a[3 * i + 1] * b[j + 1] + a[3 * i + 2] * b[j + 2];
  }
}

const along = (m: Float64Array, column: number, c: Float64Array, o: number): number =>
  m[column] * c[o] + m[column + 1] * c[o + 1] + m[column + 2] * c[o + 2];

function identity(q: Float64Array): void {
  q[0] = 0;
  q[1] = 0;
  q[2] = 0;
  q[3] = 1;
}
