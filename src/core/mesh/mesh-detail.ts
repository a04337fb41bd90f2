import type { LeafGrain } from '../look/leaf-mesh.ts';

/** How finely a tree is meshed. `far` is for the last of several levels of detail. */
export type MeshGrade = 'far' | 'low' | 'medium' | 'high';

/** What a grade means. */
export interface GradeRule {
  /** How far a flat side may lie inside the round stem, metres. */
  readonly sag: number;
  /** Least and most sides of a stem. */
  readonly sectors: readonly [least: number, most: number];
  /** Turn of the axis between two rings, degrees. */
  readonly turn: number;
  /** Rings of a trunk's flare, and of the collar of a stem on its parent. */
  readonly flare: number;
  readonly collar: number;
  /** Stems that are thinner at their base are left out, metres of radius. */
  readonly thinnest: number;
  /** How leaves are outlined, and the part of them that is kept, the rest being made up for by larger ones. */
  readonly leaf: LeafGrain;
  readonly leaves: number;
}

export const GRADES: Readonly<Record<MeshGrade, GradeRule>> = {
  high: { sag: 0.0012, sectors: [5, 30], turn: 9, flare: 18, collar: 3, thinnest: 0, leaf: 'near', leaves: 1 },
  medium: { sag: 0.004, sectors: [3, 18], turn: 18, flare: 12, collar: 2, thinnest: 0, leaf: 'middle', leaves: 1 },
  low: { sag: 0.012, sectors: [3, 10], turn: 30, flare: 7, collar: 1, thinnest: 0.0006, leaf: 'far', leaves: 0.6 },
  far: { sag: 0.04, sectors: [3, 6], turn: 60, flare: 4, collar: 0, thinnest: 0.004, leaf: 'far', leaves: 0.15 },
};

/** The grades of up to three levels of detail, the finest first. */
export const gradesFrom = (finest: Exclude<MeshGrade, 'far'>): readonly MeshGrade[] => {
  const order: readonly MeshGrade[] = ['high', 'medium', 'low', 'far'];
  return order.slice(order.indexOf(finest)).slice(0, 3);
};

/** Least turns of the arc whose sagitta is `sag` on a unit circle: half a side of a polygon. By a series, the same in every engine. */
const halfSide = (sag: number): number => Math.sqrt(2 * sag * (1 + sag / 6));

/** Sides of a stem of a radius in metres; lobes get at least four each. */
export function sectorsOf(radius: number, rule: GradeRule, lobes = 0, lobeDepth = 0): number {
  const [least, most] = rule.sectors;
  const share = Math.min(1, rule.sag / Math.max(radius, 1e-9));
  const sectors = Math.min(most, Math.max(least, Math.ceil(Math.PI / halfSide(share))));
  if (lobeDepth <= 0 || lobes < 1) return sectors;
  const n = Math.round(lobes);
  return n * Math.max(4, Math.ceil(sectors / n));
}
