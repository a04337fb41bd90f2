import type { PackedTree } from '../core/pack/packed.ts';

/** Bytes of a packed tree's arrays. */
export const bytesOf = ({ pieces, restPose, branches, leaves, mechanics }: PackedTree): number =>
  [pieces.data, restPose.data, branches.data, leaves.data, mechanics].reduce(
    (sum, { byteLength }) => sum + byteLength,
    0,
  );

/** Keeps trees by name within so many bytes; those that were not asked for the longest go first. */
export class TreeCache {
  readonly #most: number;
  /** In the order of their last use. */
  readonly #trees = new Map<string, PackedTree>();
  #bytes = 0;

  constructor(most: number) {
    this.#most = most;
  }

  get bytes(): number {
    return this.#bytes;
  }

  get(name: string): PackedTree | undefined {
    const tree = this.#trees.get(name);
    if (!tree) return undefined;
    this.#trees.delete(name);
    this.#trees.set(name, tree);
    return tree;
  }

  /** Takes a tree; one that is larger than all that may be kept is not. */
  put(name: string, tree: PackedTree): void {
    this.#drop(name);
    this.#trees.set(name, tree);
    this.#bytes += bytesOf(tree);
    for (const oldest of this.#trees.keys()) {
      if (this.#bytes <= this.#most) break;
      this.#drop(oldest);
    }
  }

  #drop(name: string): void {
    const tree = this.#trees.get(name);
    if (!tree) return;
    this.#trees.delete(name);
    this.#bytes -= bytesOf(tree);
  }
}
