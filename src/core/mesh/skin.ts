import type { Pieces } from '../pieces/pieces.ts';
import type { Skeleton } from './skeleton.ts';

/** What moves each vertex: the three joints of the piece that it goes with. The weights add up to 65535. */
export interface Skin {
  /** INFLUENCES a vertex; where a weight is 0, so is its joint. */
  readonly joints: Uint16Array;
  readonly weights: Uint16Array;
}

/** Joints of a vertex. */
export const INFLUENCES = 3;

/** Most joints that two bytes can tell apart. */
export const MOST_JOINTS = 65536;

/**
 * For vertices at the Bezier parameters `u` of `piece`: the joint at its base weighs (1-u)^2, its bone 2u(1-u), the joint at its end u^2.
 *
 * For small bends of a straight piece that is what its cubic does, exactly: with a = the way of P2 and b = that of P3, both across, the bone
 * moves the point by b u, the end by b - 3(1-u)(b-a), and the sum is 3u^2(1-u) a + u^3 b. What grows on a piece farther out and has no
 * bones rides, stiff, on the point that it grows from. Source: ours.
 */
export function skinOf(
  { start, bone, end }: Pick<Skeleton, 'start' | 'bone' | 'end'>,
  { parent, v }: Pick<Pieces, 'parent' | 'v'>,
  piece: ArrayLike<number>,
  u: ArrayLike<number>,
): Skin {
  // Where each piece without bones hangs on one that has them: parents come first.
  const anchor = new Int32Array(start.length);
  const at = new Float32Array(start.length);
  for (let i = 0; i < start.length; i++) {
    const on = parent[i]!;
    const boned = start[i]! >= 0;
    anchor[i] = boned ? i : start[on]! >= 0 ? on : anchor[on]!;
    at[i] = boned ? 0 : start[on]! >= 0 ? v[i]! : at[on]!;
  }
  const joints = new Uint16Array(INFLUENCES * piece.length);
  const weights = new Uint16Array(INFLUENCES * piece.length);
  for (let i = 0; i < piece.length; i++) {
    const p = piece[i]!;
    const of = anchor[p]!;
    const x = start[p]! >= 0 ? u[i]! : at[p]!;
    const last = Math.round(65535 * x * x);
    const first = Math.round(65535 * (1 - x) * (1 - x));
    const k = INFLUENCES * i;
    weights[k] = first;
    weights[k + 1] = 65535 - first - last;
    weights[k + 2] = last;
    joints[k] = first > 0 ? start[of]! : 0;
    joints[k + 1] = weights[k + 1]! > 0 ? bone[of]! : 0;
    joints[k + 2] = last > 0 ? end[of]! : 0;
  }
  return { joints, weights };
}

/** The joint that has most of a say in vertex i. */
export function heaviest({ joints, weights }: Skin, i: number): number {
  let best = INFLUENCES * i;
  for (let k = best + 1; k < INFLUENCES * (i + 1); k++) if (weights[k]! > weights[best]!) best = k;
  return joints[best]!;
}
