import { createWindState, windStateAt } from '../../../src/core/wind/fade.ts';
import { windForce } from '../../../src/core/wind/force.ts';
import type { Wind } from '../../../src/core/wind/wind.ts';

/** What a wind does at one place: metres of force. */
export interface Felt {
  /** Mean force, as a vector. */
  readonly mean: readonly [x: number, y: number];
  /** Deviation about that mean, both axes together. */
  readonly deviation: number;
  /** Greatest force. */
  readonly peak: number;
}

/** The force of a wind at (x, y, z) over `seconds` from time 0 on, ten times a second. */
export function felt(wind: Wind, seconds: number, [x, y, z] = [0, 0, 10]): Felt {
  const state = createWindState();
  const count = Math.round(10 * seconds);
  let [sx, sy, squares, peak] = [0, 0, 0, 0];
  for (let i = 0; i < count; i++) {
    const [fx, fy] = windForce(windStateAt(wind, i / 10, undefined, state), x, y, z);
    sx += fx;
    sy += fy;
    squares += fx * fx + fy * fy;
    peak = Math.max(peak, Math.hypot(fx, fy));
  }
  const mean = [sx / count, sy / count] as const;
  return { mean, deviation: Math.sqrt(Math.max(0, squares / count - mean[0] ** 2 - mean[1] ** 2)), peak };
}
