import type { Box3 } from 'three';
import type { TreeStats } from '../../src/core/grow/stats.ts';
import { growPacked } from '../../src/core/pack/grow-packed.ts';
import type { PackedTree } from '../../src/core/pack/packed.ts';
import type { StemTable } from '../../src/core/pack/stem-table.ts';
import { parseSpecies } from '../../src/core/species/parse.ts';
import type { Species } from '../../src/core/species/species.ts';
import { uprightBox } from '../../src/view/tree-extent.ts';

/** A tree grown in the page, without the worker. */
export interface Grown {
  readonly species: Species;
  readonly packed: PackedTree;
  readonly stems: StemTable;
  readonly stats: TreeStats;
  /** Box at rest, metres, y up. */
  readonly box: Box3;
}

/** A shipped species by name, changed by `edit`. */
export async function grown(name: string, seed: number, edit?: (species: Species) => Species): Promise<Grown> {
  const read = parseSpecies(await (await fetch(`/species/${name}.json`)).text()).species!;
  const species = edit ? edit(read) : read;
  const { packed, stems, stats } = growPacked(species, seed);
  return { species, packed, stems, stats, box: uprightBox(packed.bounds) };
}

/** Fewer branches and leaves: what software GL draws in a test. */
export const small = (species: Species): Species => ({
  ...species,
  levels: species.levels.map((level, i) => ({ ...level, branches: i === 1 ? 14 : i === 2 ? 8 : level.branches })),
  leaves: { ...species.leaves, count: 8 },
});
