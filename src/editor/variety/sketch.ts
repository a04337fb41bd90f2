import { BRANCH_LAYERS, TEXEL } from '../../core/pack/layout.ts';
import { unpackPose } from '../../core/pack/unpack.ts';
import type { GrownTree } from '../../view/picture/grow-tree.ts';

/** A tree as lines: what is seen of it before it is drawn. Metres; x to the right, y down, the foot at 0. */
export interface Sketch {
  /** Lines of one thickness in metres, thick ones first. */
  readonly strokes: readonly { readonly width: number; readonly path: string }[];
  readonly height: number;
  /** Farthest from the trunk, to either side. */
  readonly reach: number;
}

/** Radians about the vertical from which a tree is first seen: that of the stage. */
const AZIMUTH = 0.2;

/** Pieces that are drawn at most. */
const MOST = 1500;

/** Radii, as parts of the thickest, between which lines are drawn with one width. */
const STEPS = [0.5, 0.25, 0.12, 0.06, 0.03, 0] as const;

const short = (metres: number): string => metres.toFixed(2);

/** The pieces of a tree as curves, as it is first seen, without perspective. */
export function sketchOf({ packed }: GrownTree): Sketch {
  const { branches, restPose, levels, bounds } = packed;
  const span = BRANCH_LAYERS.SPAN * branches.width * branches.height * TEXEL;
  const [cos, sin] = [Math.cos(AZIMUTH), Math.sin(AZIMUTH)];
  const paths = STEPS.map(() => '');
  let thickest = 0;
  const pieces = levels.flatMap(({ start, count }) =>
    Array.from({ length: count }, (_, i) => {
      const at = span + (start + i) * TEXEL;
      const [piece, z0, z1, base] = branches.data.slice(at, at + 4) as unknown as [number, number, number, number];
      const radius = base * (1 - 0.9 * ((z0 + z1) / 2));
      thickest = Math.max(thickest, radius);
      return { piece, radius };
    }),
  );
  for (const { piece, radius } of pieces.slice(0, MOST)) {
    const [p0, ...rest] = unpackPose(restPose, piece).points.map(
      ([x, y, z]) => `${short(x * cos + y * sin)} ${short(-z)}`,
    );
    paths[STEPS.findIndex((step) => radius >= step * thickest)] += `M${p0}C${rest.join(' ')}`;
  }
  const [x0, y0, , x1, y1, z1] = bounds as unknown as [number, number, number, number, number, number];
  return {
    strokes: STEPS.map((step, i) => ({ width: 2 * thickest * (step * 1.4 || 0.015), path: paths[i]! })).filter(
      ({ path }) => path !== '',
    ),
    height: Math.max(z1, 0.1),
    reach: Math.max(-x0, x1, -y0, y1, 0.05),
  };
}

/** The size that several trees are drawn in, all at the same scale: metres, the trunk in the middle. */
export interface Frame {
  readonly width: number;
  readonly height: number;
}

/** How much more twigs and leaves reach than the stems of a sketch. */
const TWIGS = 1.08;

/** The frame into which all the sketched trees fit. */
export const frameOf = (sketches: readonly Sketch[]): Frame => ({
  width: 2 * TWIGS * Math.max(...sketches.map((s) => s.reach)),
  height: TWIGS * Math.max(...sketches.map((s) => s.height)),
});
