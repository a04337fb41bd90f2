import type { PackedTree } from '../pack/packed.ts';
import type { Pieces } from '../pieces/pieces.ts';
import { atan2 } from './elementary.ts';
import { parametersOf, RADIANS, stepsOf } from './plan.ts';
import type { Tree } from './tree.ts';

export interface Spread {
  readonly mean: number;
  readonly min: number;
  readonly max: number;
}

/** One level of stems. Clones are counted in `clones`, `segments` and `pieces` alone. */
export interface LevelStats {
  readonly level: number;
  readonly stems: number;
  readonly clones: number;
  /** The paper's segments: nCurveRes a stem, fewer a clone. */
  readonly segments: number;
  readonly pieces: number;
  /** Metres. */
  readonly length: Spread & { readonly sum: number };
  /** Metres. */
  readonly baseRadius: Spread;
  /** Angle between a stem's first segment and the vertical. */
  readonly declinationDeg: { readonly mean: number };
}

/** Figures of a tree, as `windgrove stats` prints them. */
export interface TreeStats {
  readonly species: string;
  readonly seed: number;
  /** Highest point of a stem's axis above the ground, and the largest distance of one from the tree's z axis, in metres. */
  readonly height: number;
  readonly radius: number;
  readonly levels: readonly LevelStats[];
  readonly leaves: number;
  readonly pieces: number;
  readonly maxDepth: number;
  /** Bytes on the GPU. */
  readonly bytes: number;
  /** Time of growing, fitting and packing together. */
  readonly milliseconds: number;
}

/** What growing alone does not know. */
export interface Measured {
  readonly pieces?: Pieces;
  readonly packed?: PackedTree;
  readonly milliseconds?: number;
}

/** Figures of a grown tree; what is not given in `measured` counts as 0. */
export function treeStats(tree: Tree, measured: Measured = {}): TreeStats {
  const { stems, leaves, species, seed } = tree;
  const { pieces, packed } = measured;
  const levels: LevelStats[] = [];
  let deepest = 0;
  for (let i = 0; i < stems.count; i++) deepest = Math.max(deepest, stems.level[i]);
  for (let level = 0; level <= deepest; level++) levels.push(levelStats(tree, level, pieces));
  const { height, radius } = extent(stems.nodePosition);
  return {
    species: species.name,
    seed,
    height,
    radius,
    levels,
    leaves: leaves.count,
    pieces: pieces?.count ?? 0,
    maxDepth: pieces?.maxDepth ?? 0,
    bytes: packed ? packedBytes(packed) : 0,
    milliseconds: measured.milliseconds ?? 0,
  };
}

/** Bytes that a packed tree takes on the GPU: what is read of pieces, branches and leaves, and both sets of poses. */
export const packedBytes = ({ pieces, restPose, branches, leaves }: PackedTree): number =>
  pieces.data.byteLength + 2 * restPose.data.byteLength + branches.data.byteLength + leaves.data.byteLength;

function levelStats({ stems, species }: Tree, level: number, pieces: Pieces | undefined): LevelStats {
  const steps = stepsOf(parametersOf(species, level));
  const length = new Summary();
  const radius = new Summary();
  const declination = new Summary();
  let clones = 0;
  let segments = 0;
  let covering = 0;
  for (let i = 0; i < stems.count; i++) {
    if (stems.level[i] !== level) continue;
    const first = stems.nodeStart[i];
    segments += (stems.nodeStart[i + 1] - 1 - first) / steps;
    if (stems.clone[i] === 1) {
      clones++;
      continue;
    }
    length.add(stems.length[i]);
    radius.add(stems.baseRadius[i]);
    const [x, y, z] = stems.nodeFrame.subarray(9 * first + 6, 9 * first + 9);
    declination.add(atan2(Math.sqrt(x * x + y * y), z) / RADIANS);
  }
  if (pieces) for (let i = 0; i < pieces.count; i++) if (pieces.level[i] === level) covering++;
  return {
    level,
    stems: length.count,
    clones,
    segments,
    pieces: covering,
    length: { sum: length.sum, ...length.spread() },
    baseRadius: radius.spread(),
    declinationDeg: { mean: declination.spread().mean },
  };
}

class Summary {
  count = 0;
  sum = 0;
  private least = Number.POSITIVE_INFINITY;
  private most = Number.NEGATIVE_INFINITY;

  add(value: number): void {
    this.count++;
    this.sum += value;
    this.least = Math.min(this.least, value);
    this.most = Math.max(this.most, value);
  }

  /** Zeros where nothing was added: JSON has no infinity. */
  spread(): Spread {
    return this.count === 0
      ? { mean: 0, min: 0, max: 0 }
      : { mean: this.sum / this.count, min: this.least, max: this.most };
  }
}

function extent(nodes: Float32Array): { height: number; radius: number } {
  let height = 0;
  let square = 0;
  for (let n = 0; n < nodes.length; n += 3) {
    height = Math.max(height, nodes[n + 2]);
    square = Math.max(square, nodes[n] * nodes[n] + nodes[n + 1] * nodes[n + 1]);
  }
  return { height, radius: Math.sqrt(square) };
}
