import { DRAW, spread, streamOf } from '../../../core/grow/draws.ts';
import type { StemTable } from '../../../core/pack/stem-table.ts';
import type { Species } from '../../../core/species/species.ts';

/** A tree from the side, in parts of its size: x to the right of its axis, z up from the ground. */
export interface Silhouette {
  /** Lines of stems, thick ones first: x0, z0, x1, z1 each. */
  readonly lines: Float32Array;
  /** Farthest that anything reaches from the axis, at even heights from the ground to `top`. */
  readonly reach: Float32Array;
  readonly top: number;
  readonly radius: number;
}

/** Stems that are drawn: more are a grey blur, and cost. */
const MOST_LINES = 900;
const BINS = 28;

/** The size of a tree as it was grown, and its stretch: Scale +- ScaleV, ZScale +- ZScaleV (weber-penn.md, rows 18 and 53). */
export function grownSize({ tree }: Species, seed: number): { readonly scale: number; readonly stretch: number } {
  const stream = streamOf(seed >>> 0);
  return {
    scale: Math.max(tree.scale + spread(stream, DRAW.scale, tree.scaleV), tree.scale / 4),
    stretch: Math.max(tree.zScale + spread(stream, DRAW.zScale, tree.zScaleV), 0.01),
  };
}

/** The outline of a tree from the bases and tips of its stems. */
export function silhouette(stems: StemTable, species: Species, seed: number): Silhouette {
  const { scale, stretch } = grownSize(species, seed);
  const { base, tip, level, count } = stems;
  let top = 0;
  let radius = 0;
  for (let i = 0; i < count; i++) {
    top = Math.max(top, (tip[3 * i + 2] as number) / (scale * stretch));
    radius = Math.max(radius, Math.hypot(tip[3 * i]!, tip[3 * i + 1]!) / scale);
  }
  const reach = new Float32Array(BINS);
  for (let i = 0; i < count; i++) {
    const bin = Math.floor((tip[3 * i + 2]! / (scale * stretch) / (top || 1)) * BINS);
    const at = Math.min(Math.max(bin, 0), BINS - 1);
    reach[at] = Math.max(reach[at]!, Math.hypot(tip[3 * i]!, tip[3 * i + 1]!) / scale);
  }
  const lines: number[] = [];
  for (let wanted = 0; wanted <= 2; wanted++) {
    const there = stems.countOfLevel[wanted] ?? 0;
    const room = MOST_LINES - lines.length / 4;
    // Every n-th, so that what is left out is left out everywhere.
    const every = Math.max(1, Math.ceil(there / Math.max(room, 1)));
    let seen = 0;
    for (let i = 0; i < count && lines.length / 4 < MOST_LINES; i++) {
      if (level[i] !== wanted || seen++ % every !== 0) continue;
      lines.push(
        base[3 * i]! / scale,
        base[3 * i + 2]! / (scale * stretch),
        tip[3 * i]! / scale,
        tip[3 * i + 2]! / (scale * stretch),
      );
    }
  }
  return { lines: Float32Array.from(lines), reach, top, radius };
}
