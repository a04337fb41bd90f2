import type { Species } from '../species/species.ts';
import { DRAW, spread, streamOf } from './draws.ts';

/** The size of one tree of a species. */
export interface TreeSize {
  /** Scale +- ScaleV in metres: what the envelope of pruning goes by. */
  readonly scale: number;
  /** ZScale +- ZScaleV: the finished tree is stretched by it. */
  readonly stretch: number;
  /** Bare part of the trunk. */
  readonly baseSize: number;
}

/** What the seed makes of a species' size. */
export function treeSize({ tree }: Species, seed: number): TreeSize {
  const stream = streamOf(seed >>> 0);
  return {
    // Row 53: a tree is never smaller than a quarter of its scale, whatever ScaleV says.
    scale: Math.max(tree.scale + spread(stream, DRAW.scale, tree.scaleV), tree.scale / 4),
    stretch: Math.max(tree.zScale + spread(stream, DRAW.zScale, tree.zScaleV), 0.01),
    baseSize: tree.baseSize,
  };
}
