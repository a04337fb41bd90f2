import type { LevelParameters, Species } from '../species/species.ts';
import { curveDeltas } from './curve.ts';

/** Degrees to radians. */
export const RADIANS = Math.PI / 180;

/** What growing needs of a level's parameters, in radians and whole numbers, worked out once a tree. */
export interface LevelPlan {
  readonly level: number;
  readonly parameters: LevelParameters;
  /** nCurveRes. */
  readonly segments: number;
  /** Steps, each with a node, that a segment is made of: 1, more in a helix. */
  readonly steps: number;
  /** Turn of each segment about x, without its random part. */
  readonly deltas: Float64Array;
  /** Largest random turn of a segment about x, and about y. */
  readonly curveV: number;
  readonly sideV: number;
  /** Declination of a helix from the stem's axis, 0 where the stem is none, and turn of one step about that axis. */
  readonly helix: number;
  readonly helixStep: number;
  readonly splitAngle: number;
  readonly splitAngleV: number;
  readonly downAngle: number;
  readonly downAngleV: number;
  readonly rotate: number;
  readonly rotateV: number;
  /** AttractionUp where it acts: level 2 and deeper (Weber & Penn 1995, 4.8; row 38). */
  readonly attraction: number;
}

/** The parameters of a level; deeper levels than the file has use its last (row 51). */
export const parametersOf = (species: Species, level: number): LevelParameters =>
  species.levels[Math.min(level, 3, species.levels.length - 1)];

/** Steps a segment: a helix needs at least eight nodes a turn to look like one. */
export const stepsOf = (p: LevelParameters): number =>
  p.curveV < 0 ? Math.min(Math.max(Math.ceil(8 * Math.abs(p.helixTurns)), 1), 16) : 1;

export function planLevel(species: Species, level: number): LevelPlan {
  const p = parametersOf(species, level);
  const segments = Math.max(1, Math.round(p.curveRes));
  const steps = stepsOf(p);
  const helix = p.curveV < 0;
  return {
    level,
    parameters: p,
    segments,
    steps,
    // A helix has its own course in place of the curve (4.1; row 28).
    deltas: Float64Array.from(curveDeltas(helix ? 0 : p.curve * RADIANS, helix ? 0 : p.curveBack * RADIANS, segments)),
    curveV: helix ? 0 : (p.curveV * RADIANS) / segments,
    sideV: (p.curveSideV * RADIANS) / segments,
    helix: helix ? -p.curveV * RADIANS : 0,
    helixStep: (2 * Math.PI * p.helixTurns) / steps,
    splitAngle: p.splitAngle * RADIANS,
    splitAngleV: p.splitAngleV * RADIANS,
    downAngle: p.downAngle * RADIANS,
    downAngleV: p.downAngleV * RADIANS,
    rotate: p.rotate * RADIANS,
    rotateV: p.rotateV * RADIANS,
    attraction: level >= 2 ? species.tree.attractionUp : 0,
  };
}
