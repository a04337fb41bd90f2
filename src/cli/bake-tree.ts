import { join } from 'node:path';
import { exportTree } from '../core/io/export-tree.ts';
import { growPacked } from '../core/pack/grow-packed.ts';
import { hashPacked } from '../core/pack/hash-packed.ts';
import { type BakeItem, type BakePlan, sha256 } from './bake-plan.ts';
import { isForeseen } from './foreseen.ts';
import { writeWhole } from './write-file.ts';

/** A file of a baked tree; `file` is its path in the folder of the bake, with slashes. */
export interface BakedFile {
  readonly file: string;
  readonly bytes: number;
  readonly sha256: string;
}

/** What the manifest says of a tree. */
export interface BakedTree {
  readonly index: number;
  readonly species: string;
  readonly seed: number;
  readonly files?: readonly BakedFile[];
  /** `hashPacked`: equal to that of the same tree in every browser. */
  readonly hash?: string;
  readonly stems?: number;
  readonly pieces?: number;
  readonly leaves?: number;
  /** Metres. */
  readonly height?: number;
  /** Why there is no such tree: the species asks for too much with this seed, or for nothing. */
  readonly error?: string;
}

/** Grows a tree and writes its files; the same call gives the same bytes, whoever makes it. */
export async function bakeTree(
  plan: BakePlan,
  { index, species: which, seed }: BakeItem,
  folder: string,
): Promise<BakedTree> {
  const { id, species } = plan.species[which]!;
  const tree = { index, species: id, seed };
  try {
    const grown = growPacked(species, seed);
    const files =
      plan.options === null
        ? []
        : await exportTree(species, seed, plan.wind.wind, plan.options, undefined, { name: `${id}-${seed}`, grown });
    const written = files.map(({ name, bytes }): BakedFile => {
      const file = `${id}/${name}`;
      writeWhole(join(folder, file), bytes);
      return { file, bytes: bytes.length, sha256: sha256(bytes) };
    });
    const { stats } = grown;
    return {
      ...tree,
      files: written,
      hash: hashPacked(grown.packed),
      stems: grown.tree.stems.count,
      pieces: stats.pieces,
      leaves: stats.leaves,
      height: stats.height,
    };
  } catch (error) {
    if (!isForeseen(error)) throw error;
    return { ...tree, error: error.message };
  }
}
