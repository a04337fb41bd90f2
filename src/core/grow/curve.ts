import type { Vec3 } from '../math/vec3.ts';
import { newFrame, turnX } from './frame.ts';

/**
 * The turn of each of n segments about its local x axis, in the unit of `curve` (Weber & Penn 1995, 4.1).
 *
 * Where curveBack is not 0, each half of the stem has its exact share, so an odd n splits its middle segment (row 26).
 * The list counts every segment; growing does not apply the first, so a child keeps its down angle (row 25).
 */
export function curveDeltas(curve: number, curveBack: number, n: number): number[] {
  const deltas: number[] = [];
  for (let i = 0; i < n; i++) {
    const first = Math.min(Math.max(n / 2 - i, 0), 1);
    deltas.push(curveBack === 0 ? curve / n : (first * curve) / (n / 2) + ((1 - first) * curveBack) / (n / 2));
  }
  return deltas;
}

/** The nodes of a stem of this length in its own frame, each segment turned by its delta (radians) first. */
export function stemPolyline(length: number, deltas: readonly number[]): Vec3[] {
  const frame = newFrame();
  const step = length / deltas.length;
  const nodes: Vec3[] = [[0, 0, 0]];
  for (const delta of deltas) {
    turnX(frame, delta);
    const [x, y, z] = nodes[nodes.length - 1];
    nodes.push([x + step * frame[6], y + step * frame[7], z + step * frame[8]]);
  }
  return nodes;
}
