import { angleBetween, productRotation, relativeRotation, turned } from './joint-math.ts';
import { between, keptFrames, type Track } from './reduce-keys.ts';
import { JOINT, type Skeleton } from './skeleton.ts';

/** Keys of one joint, relative to the joint that it hangs on. */
export interface JointKeys {
  /** Seconds; the first is 0, the last the length of the clip. */
  readonly times: Float32Array;
  /** 4 a key, or 3; the last is the first, to the bit. */
  readonly values: Float32Array;
}

/** What of a joint moves; null: it stays as it is at rest. */
export interface JointTracks {
  readonly rotation: JointKeys | null;
  readonly translation: JointKeys | null;
}

/** A clip of a skeleton that comes around. */
export interface JointClip {
  readonly seconds: number;
  readonly joints: readonly JointTracks[];
  /** Keys in all, and what they would be at every frame. */
  readonly keys: number;
  readonly allKeys: number;
}

/** Where joint j is relative to the one that it hangs on (JOINT numbers), or in space where it hangs on none. */
export function localPlace(
  all: Float64Array,
  from: number,
  parent: number,
  of: Float64Array,
  at: number,
  out: Float64Array,
  to: number,
) {
  if (parent < 0) {
    for (let k = 0; k < JOINT; k++) out[to + k] = of[at + k]!;
    return;
  }
  turned(all, from + 3, -1, of[at]! - all[from]!, of[at + 1]! - all[from + 1]!, of[at + 2]! - all[from + 2]!, out, to);
  relativeRotation(all, from + 3, of, at + 3, out, to + 3);
}

/**
 * Keys for a skeleton from its joints at frames 0..frames (the last being the first again), JOINT numbers each, in space.
 *
 * A joint's way is measured against where its parent's keys put the parent, not where it was: so no errors add up along a branch, and at
 * every frame every joint is within the tolerances (radians, metres) of its sample. `rest`: the joints at rest.
 */
export function reduceClip(
  skeleton: Skeleton,
  rest: Float64Array,
  frames: readonly Float64Array[],
  seconds: number,
  angle: number,
  distance: number,
  report: (done: number) => void = () => {},
): JointClip {
  const last = frames.length - 1;
  // Where the keys put each joint at each frame.
  const made = Array.from({ length: frames.length }, () => new Float64Array(JOINT * skeleton.count));
  const joints: JointTracks[] = [];
  const at = new Float64Array(JOINT);
  const still = new Float64Array(JOINT);
  const place: Track = { values: new Float64Array(3 * (last + 1)), size: 3 };
  const turn: Track = { values: new Float64Array(4 * (last + 1)), size: 4 };
  let keys = 0;
  for (let j = 0; j < skeleton.count; j++) {
    const parent = skeleton.parent[j]!;
    localPlace(rest, JOINT * parent, parent, rest, JOINT * j, still, 0);
    for (let f = 0; f <= last; f++) {
      // The last frame is the first: the loop has no seam.
      const of = f === last ? 0 : f;
      localPlace(made[of]!, JOINT * parent, parent, frames[of]!, JOINT * j, at, 0);
      place.values.set(at.subarray(0, 3), 3 * f);
      turn.values.set(at.subarray(3, 7), 4 * f);
    }
    alignSigns(turn.values, still);
    const rotation = keysOf(turn, last, seconds, angle, still.subarray(3, 7));
    const translation = keysOf(place, last, seconds, distance, still.subarray(0, 3));
    keys += (rotation?.times.length ?? 0) + (translation?.times.length ?? 0);
    joints.push({ rotation, translation });
    rebuild(
      made,
      skeleton,
      j,
      rotation ? turn : null,
      translation ? place : null,
      still,
      last,
      rotation,
      translation,
      seconds,
    );
    if ((j & 63) === 0) report(j / skeleton.count);
  }
  return { seconds, joints, keys, allKeys: 2 * skeleton.count * (last + 1) };
}

/** Rotations are the same with the opposite sign; neighbours get the same one, so that the way between is short. */
function alignSigns(values: Float64Array, still: Float64Array): void {
  for (let f = 0; f < values.length / 4; f++) {
    let cosine = 0;
    for (let k = 0; k < 4; k++) cosine += values[4 * f + k]! * (f === 0 ? still[3 + k]! : values[4 * (f - 1) + k]!);
    if (cosine < 0) for (let k = 0; k < 4; k++) values[4 * f + k] = -values[4 * f + k]!;
  }
  const end = values.length - 4;
  for (let k = 0; k < 4; k++) values[end + k] = values[k]!;
}

/** The keys that a track needs, as they are stored, or null where it never leaves `still` by more than the tolerance. */
function keysOf(track: Track, last: number, seconds: number, tolerance: number, still: Float64Array): JointKeys | null {
  const { values, size } = track;
  let moved = 0;
  for (let f = 0; f < last; f++) {
    if (size === 4) moved = Math.max(moved, angleBetween(values, 4 * f, still, 0));
    else {
      const [x, y, z] = [values[3 * f]! - still[0]!, values[3 * f + 1]! - still[1]!, values[3 * f + 2]! - still[2]!];
      moved = Math.max(moved, Math.sqrt(x * x + y * y + z * z));
    }
  }
  if (moved <= tolerance) return null;
  const kept = keptFrames(track, last, tolerance);
  return {
    times: Float32Array.from(kept, (f) => (f / last) * seconds),
    values: Float32Array.from(kept.flatMap((f) => Array.from(values.subarray(size * f, size * f + size)))),
  };
}

/** Where the keys of joint j put it at every frame, given where they put its parent. */
function rebuild(
  made: readonly Float64Array[],
  skeleton: Skeleton,
  j: number,
  turn: Track | null,
  place: Track | null,
  still: Float64Array,
  last: number,
  rotation: JointKeys | null,
  translation: JointKeys | null,
  seconds: number,
): void {
  const parent = skeleton.parent[j]!;
  const local = new Float64Array(JOINT);
  for (let f = 0; f <= last; f++) {
    local.set(still);
    if (place && translation) spanAt(translation, f, last, seconds, (a, b) => between(place, a, b, f, local, 0));
    if (turn && rotation) spanAt(rotation, f, last, seconds, (a, b) => between(turn, a, b, f, local, 3));
    const out = made[f]!;
    if (parent < 0) {
      out.set(local, JOINT * j);
      continue;
    }
    const from = JOINT * parent;
    turned(out, from + 3, 1, local[0]!, local[1]!, local[2]!, out, JOINT * j);
    for (let k = 0; k < 3; k++) out[JOINT * j + k] = out[JOINT * j + k]! + out[from + k]!;
    productRotation(out, from + 3, local, 3, out, JOINT * j + 3);
  }
}

/** The frames of the keys around frame f. */
function spanAt(
  { times }: JointKeys,
  f: number,
  last: number,
  seconds: number,
  use: (a: number, b: number) => void,
): void {
  const frameOf = (k: number): number => Math.round((times[k]! * last) / seconds);
  let k = 0;
  while (k + 2 < times.length && frameOf(k + 1) <= f) k++;
  use(frameOf(k), frameOf(Math.min(k + 1, times.length - 1)));
}
