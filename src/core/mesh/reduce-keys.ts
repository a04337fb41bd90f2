import { angleBetween, slerp } from './joint-math.ts';

/** A track at frames 0..frames: `size` numbers each; 4 is a rotation, 3 a place. */
export interface Track {
  readonly values: Float64Array;
  readonly size: 3 | 4;
}

const scratch = new Float64Array(4);

/** The track between keys at frames a and b, at frame f, into `out`: as a player of glTF interpolates. */
export function between({ values, size }: Track, a: number, b: number, f: number, out: Float64Array, to: number): void {
  const part = b > a ? (f - a) / (b - a) : 0;
  if (size === 4) slerp(values, 4 * a, values, 4 * b, part, out, to);
  else for (let k = 0; k < 3; k++) out[to + k] = values[3 * a + k]! * (1 - part) + values[3 * b + k]! * part;
}

function off(track: Track, a: number, b: number, f: number): number {
  between(track, a, b, f, scratch, 0);
  const { values, size } = track;
  if (size === 4) return angleBetween(scratch, 0, values, 4 * f);
  let sum = 0;
  for (let k = 0; k < 3; k++) sum += (scratch[k]! - values[3 * f + k]!) ** 2;
  return Math.sqrt(sum);
}

/**
 * The frames of a track that must be kept so that all others lie within `tolerance` (radians, metres) of the way between them: the first,
 * the last, and from each the farthest that will do.
 */
export function keptFrames(track: Track, frames: number, tolerance: number): number[] {
  const kept = [0];
  let from = 0;
  while (from < frames) {
    let to = Math.min(from + 1, frames);
    while (to < frames && fits(track, from, to + 1, tolerance)) to++;
    kept.push(to);
    from = to;
  }
  return kept;
}

function fits(track: Track, a: number, b: number, tolerance: number): boolean {
  for (let f = a + 1; f < b; f++) if (off(track, a, b, f) > tolerance) return false;
  return true;
}
