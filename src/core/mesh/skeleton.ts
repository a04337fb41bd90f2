import { handlesOf, sectionFrame, transport } from '../math/frames.ts';
import { writeQuaternion } from '../math/quaternion.ts';
import { cross, type Mat3, subtract, unit, type Vec3 } from '../math/vec3.ts';
import type { GrownPacked } from '../pack/grow-packed.ts';
import { planeOf, poseOf } from '../wind/pose-plainly.ts';

/**
 * Bones of a tree: one a piece, from its base straight to its end, on all stems below a level. Before the first, between two and after the
 * last of a stem there is a joint that has the direction of the stem itself there: with it the skin bends along the piece as the
 * piece does (`skinOf`). Parents before children.
 */
export interface Skeleton {
  readonly count: number;
  /** The joint that each hangs on, -1 for the base of a trunk. */
  readonly parent: Int32Array;
  /** 'L1_012_03', the third bone of the twelfth stem of level 1; its end 'L1_012_03_end', the last 'L1_012_tip', the first 'L1_012_base'. */
  readonly names: readonly string[];
  /** The piece that says where the joint is, and which of its three it is. */
  readonly piece: Int32Array;
  readonly kind: Uint8Array;
  /** By piece: the joint at its base, its bone, and the joint at its end; -1 where it has none. */
  readonly start: Int32Array;
  readonly bone: Int32Array;
  readonly end: Int32Array;
}

const [BASE, BONE, END] = [0, 1, 2] as const;

const digits = (n: number, width: number): string => String(n).padStart(width, '0');

/** The bones of the stems below `levels`. */
export function skeletonOf({ pieces, stems }: Pick<GrownPacked, 'pieces' | 'stems'>, levels: number): Skeleton {
  const none = (): Int32Array => new Int32Array(pieces.count).fill(-1);
  const [start, bone, end] = [none(), none(), none()];
  const place = new Int32Array(pieces.count);
  const parent: number[] = [];
  const names: string[] = [];
  const piece: number[] = [];
  const kind: number[] = [];
  const add = (hangsOn: number, of: number, which: 0 | 1 | 2, name: string): number => {
    parent.push(hangsOn);
    piece.push(of);
    kind.push(which);
    names.push(name);
    return parent.length - 1;
  };
  for (let i = 0; i < pieces.count; i++) {
    const level = pieces.level[i]!;
    if (level >= levels) continue;
    const stem = pieces.stem[i]!;
    const name = `L${level}_${digits(stems.numberInLevel[stem]!, String(stems.countOfLevel[level]!).length)}`;
    const on = pieces.parent[i]!;
    if (pieces.firstOfStem[stem] === i) {
      const v = pieces.v[i]!;
      start[i] = add(on < 0 ? -1 : (v < 0.25 ? start : v > 0.75 ? end : bone)[on]!, i, BASE, `${name}_base`);
    } else {
      start[i] = end[on]!;
      place[i] = place[on]! + 1;
    }
    const own = `${name}_${digits(place[i]! + 1, 2)}`;
    bone[i] = add(start[i]!, i, BONE, own);
    end[i] = add(bone[i]!, i, END, pieces.next[i]! < 0 ? `${name}_tip` : `${own}_end`);
  }
  return {
    count: parent.length,
    parent: Int32Array.from(parent),
    names,
    piece: Int32Array.from(piece),
    kind: Uint8Array.from(kind),
    start,
    bone,
    end,
  };
}

/** Numbers of a joint's place: position (3), rotation (4). */
export const JOINT = 7;

/**
 * Where the joints are in a pose, tree space: position, and the rotation whose y axis runs along the stem (of a bone: to its end), x along T
 * and z against S of the section; JOINT numbers each. `pose` is laid out as POSE_TARGETS with `plane` floats a target; `at` tells where
 * in it a piece is.
 */
export function placeJoints(
  { count, piece, kind }: Skeleton,
  pose: Float32Array,
  plane: number,
  out: Float64Array = new Float64Array(JOINT * count),
  at: (piece: number) => number = (index) => index,
): Float64Array {
  const columns = new Float64Array(9);
  for (let j = 0; j < count; j++) {
    const { curve, o } = poseOf(pose, plane, at(piece[j]!));
    const handles = handlesOf(curve, o);
    const [u, t, s] =
      kind[j] === BONE ? boneFrame(curve.p0, curve.p3, handles) : sectionFrame(curve, handles, kind[j] === END ? 1 : 0);
    const from = kind[j] === END ? curve.p3 : curve.p0;
    for (let k = 0; k < 3; k++) {
      out[JOINT * j + k] = from[k]!;
      columns[k] = t[k]!;
      columns[3 + k] = u[k]!;
      columns[6 + k] = -s[k]!;
    }
    writeQuaternion(columns, out, JOINT * j + 3);
  }
  return out;
}

/** The frame of the base turned the short way to the chord. */
function boneFrame(from: Vec3, to: Vec3, { l0, t0 }: { l0: Vec3; t0: Vec3 }): Mat3 {
  const chord = unit(subtract(to, from), l0);
  const t = transport(t0, l0, chord);
  return [chord, t, cross(chord, t)];
}

/** The rest pose of the joints. */
export const restJoints = ({ packed }: Pick<GrownPacked, 'packed'>, skeleton: Skeleton): Float64Array =>
  placeJoints(skeleton, packed.restPose.data, planeOf(packed.restPose));
