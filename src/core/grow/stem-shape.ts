import { crownCurve } from './crown-curve.ts';
import { power, sinCos, trig } from './elementary.ts';

export { SHAPES } from './shape-names.ts';

/** The part of a species' pruning that gives the envelope its shape. */
export interface EnvelopeShape {
  readonly widthPeak: number;
  readonly powerLow: number;
  readonly powerHigh: number;
}

const clamp01 = (x: number): number => Math.min(Math.max(x, 0), 1);

function sine(angle: number): number {
  sinCos(angle);
  return trig.sin;
}

/**
 * ShapeRatio(shape, ratio): how long a stem may get at a place of the crown, 0..1; ratio is clamped to 0..1 except for the envelope,
 * which is 0 outside. Source: Weber & Penn 1995, 4.3; rows 1 and 10 of weber-penn.md.
 */
export function shapeRatio(shape: number, ratio: number, envelope?: EnvelopeShape): number {
  if (shape === 8) return envelope ? envelopeRatio(ratio, envelope) : 1;
  const r = clamp01(ratio);
  switch (shape) {
    case 0:
      return 0.2 + 0.8 * r;
    case 1:
      return 0.2 + 0.8 * sine(Math.PI * r);
    case 2:
      return 0.2 + 0.8 * sine(0.5 * Math.PI * r);
    case 4:
      return 0.5 + 0.5 * r;
    case 5:
      return r <= 0.7 ? r / 0.7 : (1 - r) / 0.3;
    case 6:
      return 1 - 0.8 * r;
    case 7:
      return r <= 0.7 ? 0.5 + (0.5 * r) / 0.7 : 0.5 + (0.5 * (1 - r)) / 0.3;
    case 9:
      return r;
    default:
      return 1;
  }
}

/** ShapeRatio(8, ratio), continuous at the peak: Weber & Penn 1995, 4.6, with row 46. */
export function envelopeRatio(ratio: number, { widthPeak, powerLow, powerHigh }: EnvelopeShape): number {
  if (!(ratio >= 0 && ratio <= 1)) return 0;
  return ratio < 1 - widthPeak
    ? power(ratio / (1 - widthPeak), powerHigh)
    : power((1 - ratio) / Math.max(widthPeak, 1e-9), powerLow);
}

/**
 * Length of a level-1 stem in metres (Weber & Penn 1995, 4.3; row 2). `relative` is nLength +- nLengthV; a `crown` curve takes the place
 * of ShapeRatio.
 */
export const mainBranchLength = (
  relative: number,
  trunk: number,
  offset: number,
  base: number,
  shape: number,
  envelope?: EnvelopeShape,
  crown?: readonly number[],
): number => {
  const ratio = (trunk - offset) / (trunk - base);
  return trunk * relative * (crown ? crownCurve(crown, 1 - ratio) : shapeRatio(shape, ratio, envelope));
};

/** Length of a stem of level 2 and deeper in metres (Weber & Penn 1995, 4.3; row 3). */
export const deeperLength = (relative: number, parent: number, offset: number): number =>
  relative * (parent - 0.6 * offset);

/** Children of a level-1 stem, a fraction: nBranches (0.2 + 0.8 (length/trunk)/relative) (4.3; row 6). */
export const countOnMainBranch = (branches: number, length: number, trunk: number, relative: number): number =>
  relative > 0 && trunk > 0 ? branches * (0.2 + (0.8 * length) / trunk / relative) : 0;

/** Children of a stem of level 2 and deeper, a fraction; `offset` is its own place on its parent (4.3; row 7). */
export const countOnDeeperStem = (branches: number, offset: number, parent: number): number =>
  branches * (1 - (0.5 * offset) / parent);

/** Leaves on a stem, a fraction; `offset` is its own place on its parent (4.5; row 40). */
export const leavesCount = (leaves: number, offset: number, parent: number, quality: number): number =>
  leaves * shapeRatio(4, offset / parent) * quality;

/**
 * Down angle in degrees where nDownAngleV < 0: it runs along the parent, without randomness (4.3; rows 12 and 13).
 * `base` is the bare part of a trunk in metres and 0 for other parents.
 */
export const downAngleAlong = (down: number, downV: number, parent: number, offset: number, base: number): number =>
  down + downV * (1 - 2 * shapeRatio(0, (parent - offset) / (parent - base)));
