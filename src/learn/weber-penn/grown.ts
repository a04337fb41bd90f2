import { grow } from '../../core/grow/grow.ts';
import type { Tree } from '../../core/grow/tree.ts';
import type { Species } from '../../core/species/species.ts';

/** A grower that remembers its last tree: what is asked for again is not grown again. `key` says all that `species` depends on. */
export function remembered(): (key: string, species: () => Species, seed: number, levels?: number) => Tree {
  let known: { readonly key: string; readonly tree: Tree } | null = null;
  return (key, species, seed, levels) => {
    const whole = `${key}/${seed}/${levels ?? 'all'}`;
    if (known?.key !== whole) known = { key: whole, tree: grow(species(), seed, levels ? { levels } : {}) };
    return known.tree;
  };
}
