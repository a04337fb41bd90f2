import type { GrownTree } from '../src/view/picture/grow-tree.ts';

/** A point of tree space, z up. */
export type Point = readonly [number, number, number];

/** The tip of a twig of the outer crown, a little above its middle, that stands out most in the direction `towards` (tree space, x and y). */
export function sprayOf({ stems, packed }: GrownTree, towards: readonly [x: number, y: number]): Point {
  const [, , low, , , high] = packed.bounds as unknown as number[];
  const middle = low! + 0.6 * (high! - low!);
  let best = -Infinity;
  let found: Point = [0, 0, middle];
  const last = stems.countOfLevel.length - 1;
  for (let i = 0; i < stems.count; i++) {
    if (stems.level[i] !== last) continue;
    const [x, y, z] = stems.tip.subarray(3 * i, 3 * i + 3) as unknown as [number, number, number];
    const out = towards[0] * x + towards[1] * y - 0.6 * Math.abs(z - middle);
    if (out <= best) continue;
    best = out;
    found = [x, y, z];
  }
  return found;
}
