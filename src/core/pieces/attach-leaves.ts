import type { Tree } from '../grow/tree.ts';
import { writeQuaternion } from '../math/quaternion.ts';
import { RECORD, recordArc, recordFrame, recordParameter, transportRecord } from './curve.ts';
import type { LeafAttachments, Pieces } from './pieces.ts';

/**
 * Hangs every leaf on the piece and the Bezier parameter under it, with its orientation in the section frame there.
 *
 * Linear in the number of leaves, nothing allocated a leaf. Leaves of one piece that stand next to each other share the
 * piece's handles, and those of a straight piece its one frame.
 */
export function attachLeaves(tree: Tree, pieces: Pieces): LeafAttachments {
  const { count, stem, z, orientation } = tree.leaves;
  const { firstOfStem, next, span } = pieces;
  const piece = new Int32Array(count);
  const vs = new Float32Array(count);
  const turned = new Float32Array(4 * count);
  const record = new Float64Array(RECORD);
  const frame = new Float64Array(9);
  const quaternion = new Float64Array(4);
  let current = -1;
  let straight = false;
  let arc = 0;
  let z0 = 0;
  let z1 = 0;
  for (let i = 0; i < count; i++) {
    let p = firstOfStem[stem[i]];
    while (next[p] >= 0 && z[i] > span[2 * p + 1]) p = next[p];
    if (p !== current) {
      current = p;
      straight = load(pieces, p, record);
      arc = straight ? 0 : recordArc(record, 0, 1);
      z0 = span[2 * p];
      z1 = span[2 * p + 1];
      if (straight) {
        recordFrame(record, 0, 0.5, frame);
        writeQuaternion(frame, quaternion, 0);
      }
    }
    let v = Math.min(1, Math.max(0, (z[i] - z0) / (z1 - z0)));
    if (!straight) {
      v = Math.fround(recordParameter(record, 0, v, arc));
      recordFrame(record, 0, v, frame);
      writeQuaternion(frame, quaternion, 0);
    }
    piece[i] = p;
    vs[i] = v;
    // The frame's inverse times the leaf's rotation.
    const ax = -quaternion[0];
    const ay = -quaternion[1];
    const az = -quaternion[2];
    const aw = quaternion[3];
    const o = 4 * i;
    const bx = orientation[o];
    const by = orientation[o + 1];
    const bz = orientation[o + 2];
    const bw = orientation[o + 3];
    const w = aw * bw - ax * bx - ay * by - az * bz;
    const sign = w < 0 ? -1 : 1;
    turned[o] = sign * (aw * bx + ax * bw + ay * bz - az * by);
    turned[o + 1] = sign * (aw * by - ax * bz + ay * bw + az * bx);
    turned[o + 2] = sign * (aw * bz + ax * by - ay * bx + az * bw);
    turned[o + 3] = sign * w;
  }
  return { piece, v: vs, orientation: turned };
}

/** Reads one piece as it is stored; true where it is straight with even steps, so that v is the arc fraction. */
function load({ control, orient, local }: Pieces, p: number, record: Float64Array): boolean {
  for (let k = 0; k < 12; k++) record[k] = control[12 * p + k];
  for (let k = 0; k < 3; k++) record[12 + k] = orient[3 * p + k];
  transportRecord(record, 0);
  const o = 7 * p;
  const end = local[o + 4];
  const small = 1e-6 * end;
  return (
    Math.abs(local[o + 5]) < small &&
    Math.abs(local[o + 6]) < small &&
    Math.abs(local[o + 2]) < small &&
    Math.abs(local[o + 3]) < small &&
    Math.abs(3 * local[o] - end) < 4 * small &&
    Math.abs(1.5 * local[o + 1] - end) < 4 * small
  );
}
