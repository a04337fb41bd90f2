import type { Species } from '../species/species.ts';

/**
 * Every stem of a tree, clones among them, as a struct of arrays; index i is one stem, parents stand before children.
 *
 * A clone is a stem of its own that starts where it left its twin: it has the twin's `length` and `baseRadius` and covers
 * the part [zStart, 1] of them, so radius, curvature and bend run on as the twin's do (Weber & Penn 1995, 4.2).
 * Metres; tree space is z-up.
 */
export interface Stems {
  readonly count: number;
  /** Level of recursion, 0 for a trunk. `count` entries, as in all arrays here unless it is said. */
  readonly level: Uint8Array;
  /** The stem that this one grows on: the parent of a child, the twin of a clone; -1 for a trunk. */
  readonly parent: Int32Array;
  /** Where it grows there, as a fraction of the parent's whole length, 0..1. */
  readonly parentZ: Float32Array;
  /** 1 where this stem is a clone of `parent`, else 0. */
  readonly clone: Uint8Array;
  /** Length in metres that the stem has, or that its twin has, from base to tip. */
  readonly length: Float32Array;
  /** Part of that length at which this stem starts: 0, or for a clone the place of the split. */
  readonly zStart: Float32Array;
  /** Radius in metres at z = 0, before taper, flare and lobes. */
  readonly baseRadius: Float32Array;
  /** Hash of seed and path: the stem's own stream of random draws. */
  readonly path: Uint32Array;
  /** First node of each stem; `count + 1` entries, the last is the number of nodes. */
  readonly nodeStart: Uint32Array;
  /** Position of each node of the axis, 3 a node, from z = zStart to z = 1 in equal steps. */
  readonly nodePosition: Float32Array;
  /** Axes x, y, z of the stem's frame at each node, 9 a node; z is the direction of the segment that starts there. */
  readonly nodeFrame: Float32Array;
}

/** Every leaf of a tree as a struct of arrays; index i is one leaf. */
export interface Leaves {
  readonly count: number;
  /** The stem that bears the leaf. */
  readonly stem: Int32Array;
  /** Where on that stem, as a fraction of its whole length, 0..1. */
  readonly z: Float32Array;
  /** Rotation (x, y, z, w) of the leaf in tree space, 4 a leaf: z runs along the midrib, y is the upper face's normal. */
  readonly orientation: Float32Array;
  /** Length of the blade in metres. */
  readonly length: Float32Array;
  /** Phase of the leaf's own motion in turns, [0, 1). */
  readonly phase: Float32Array;
}

/** What `grow` makes of a species and a seed. Nothing changes it afterwards. */
export interface Tree {
  readonly species: Species;
  readonly seed: number;
  /** Scale +- ScaleV of this tree in metres. */
  readonly scale: number;
  readonly stems: Stems;
  readonly leaves: Leaves;
}
