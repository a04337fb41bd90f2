import { MECHANICS_SIZE } from '../../../src/core/pack/layout.ts';
import type { PackedTree } from '../../../src/core/pack/packed.ts';
import { springTexels } from '../../../src/core/wind/spring-texels.ts';
import { swayTexels } from '../../../src/core/wind/sway.ts';
import { STILL } from '../../../src/core/wind/wind.ts';
import { type SmallTree, smallTree } from './small-tree.ts';

export type BentTree = SmallTree & Pick<PackedTree, 'mechanics'>;

/** A small random tree with mechanics: the deeper a piece the thinner, shorter and quicker its stem. */
export function bentTree(count: number, seed: number): BentTree {
  const tree = smallTree(count, seed);
  const mechanics = new Float32Array(MECHANICS_SIZE * count);
  const chains = tree.plan.map((_, i) => [i]);
  tree.plan.forEach(({ next, parent }, i) => {
    if (next) chains[parent].push(i);
    if (next) chains[i] = chains[parent];
  });
  tree.plan.forEach((_, i) => {
    const chain = chains[i];
    const { depth } = tree.plan[chain[0]];
    const [z0, z1] = [0, 1].map((end) => (chain.indexOf(i) + end) / chain.length);
    const level = Math.min(depth, 4);
    const length = 4.5 * 0.7 ** depth;
    const phase = (0.37 * chain[0]) % 1;
    mechanics.set(
      [z0, z1, length, 0.02 * length, Math.min(12, 2 + depth + phase), level, phase, 1, 1],
      MECHANICS_SIZE * i,
    );
  });
  return { ...tree, mechanics };
}

/** Texels of springs and sway as the settings of STILL make them. */
export const texelsOf = (tree: BentTree) => ({
  springs: springTexels(tree, STILL.spring),
  sway: swayTexels(tree, STILL.sway),
});
