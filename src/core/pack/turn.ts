import { sinCos, trig } from '../grow/elementary.ts';

/** Cosine and sine of an angle in radians, the same in every engine. */
export function turnOf(angle: number): [cos: number, sin: number] {
  sinCos(angle);
  return [trig.cos, trig.sin];
}
