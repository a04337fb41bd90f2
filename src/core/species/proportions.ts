import type { Stems, Tree } from '../grow/tree.ts';

/** Measures of one grown tree, to hold against the `facts` of its species. */
export interface Proportions {
  /** Height of the highest point of any stem's axis above the ground, metres; leaves do not count. */
  readonly height: number;
  /** Width of the crown as a part of the height: the mean of what all axes span along x and along y. */
  readonly spread: number;
  /**
   * Part of the height below the crown: the height at which the lowest main branch that bears the crown leaves its trunk. A branch of
   * level 1 bears the crown where it is at least a third as long as the longest; a tree without such branches has none, and this is 0.
   */
  readonly clear: number;
}

/** How long a main branch must be to bear the crown, as a part of the longest: shorter ones are tips and stubs. */
const BEARING = 1 / 3;

/** What a botanist would measure of a tree. Two or three levels without leaves are enough: finer stems hardly widen the crown. */
export function proportions({ stems }: Tree): Proportions {
  const { nodePosition: p } = stems;
  const least = [Infinity, Infinity];
  const most = [-Infinity, -Infinity];
  let height = 0;
  for (let n = 0; n < p.length; n += 3) {
    for (const axis of [0, 1]) {
      least[axis] = Math.min(least[axis]!, p[n + axis]!);
      most[axis] = Math.max(most[axis]!, p[n + axis]!);
    }
    height = Math.max(height, p[n + 2]!);
  }
  if (height === 0) return { height: 0, spread: 0, clear: 0 };
  const width = (most[0]! - least[0]! + most[1]! - least[1]!) / 2;
  return { height, spread: width / height, clear: Math.max(0, lowestBranch(stems)) / height };
}

/** Height of the lowest place in metres at which a main branch that bears the crown grows; 0 where there is none. */
function lowestBranch({ count, level, clone, length, nodeStart, nodePosition }: Stems): number {
  let longest = 0;
  for (let i = 0; i < count; i++) if (level[i] === 1) longest = Math.max(longest, length[i]!);
  let lowest = Infinity;
  for (let i = 0; i < count; i++) {
    if (level[i] !== 1 || clone[i] === 1 || length[i]! < BEARING * longest) continue;
    lowest = Math.min(lowest, nodePosition[3 * nodeStart[i]! + 2]!);
  }
  return longest > 0 ? lowest : 0;
}
