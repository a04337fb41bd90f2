import type { NumberParameter } from '../../../core/species/parameter.ts';

export interface Range {
  readonly min: number;
  readonly max: number;
}

/**
 * What a slider reaches where the table allows more than a hand can aim at: most trees lie within. A value beyond stretches its slider,
 * and all that is allowed can be typed.
 */
const COMFORT: Readonly<Record<string, Range>> = {
  'tree.scale': { min: 1, max: 40 },
  'tree.scaleV': { min: 0, max: 15 },
  'tree.zScale': { min: 0.3, max: 3 },
  'tree.zScaleV': { min: 0, max: 1 },
  'tree.levels': { min: 1, max: 5 },
  'tree.ratio': { min: 0.002, max: 0.08 },
  'tree.ratioPower': { min: 0.5, max: 3 },
  'tree.lobes': { min: 0, max: 16 },
  'tree.lobeDepth': { min: 0, max: 0.5 },
  'tree.flare': { min: 0, max: 3 },
  'tree.attractionUp': { min: -4, max: 4 },
  'tree.disc': { min: 0, max: 0.5 },
  'tree.bulges': { min: 0, max: 40 },
  'tree.bulgeDepth': { min: 0, max: 0.5 },
  'levels.scale': { min: 0, max: 3 },
  'levels.scaleV': { min: 0, max: 1 },
  'levels.length': { min: 0, max: 1.5 },
  'levels.lengthV': { min: 0, max: 0.5 },
  'levels.baseSplits': { min: 0, max: 5 },
  'levels.segSplits': { min: 0, max: 2.5 },
  'levels.splitAngle': { min: 0, max: 90 },
  'levels.splitAngleV': { min: 0, max: 45 },
  'levels.curveRes': { min: 1, max: 20 },
  'levels.curve': { min: -180, max: 180 },
  'levels.curveBack': { min: -180, max: 180 },
  'levels.curveV': { min: 0, max: 360 },
  'levels.curveSideV': { min: 0, max: 360 },
  'levels.helixTurns': { min: -1, max: 1 },
  'levels.downAngle': { min: 0, max: 150 },
  'levels.downAngleV': { min: -90, max: 90 },
  'levels.rotate': { min: -180, max: 180 },
  'levels.rotateV': { min: 0, max: 180 },
  'levels.branches': { min: 0, max: 80 },
  'leaves.count': { min: -30, max: 80 },
  'leaves.scale': { min: 0.01, max: 0.6 },
  'leaves.scaleX': { min: 0.05, max: 2 },
  'leaves.petiole': { min: 0, max: 2 },
  'leaves.quality': { min: 0.1, max: 2 },
  'leaves.downAngle': { min: -30, max: 180 },
  'leaves.downAngleV': { min: -90, max: 90 },
  'leaves.rotate': { min: -180, max: 180 },
  'leaves.rotateV': { min: 0, max: 180 },
  'pruning.width': { min: 0, max: 1 },
  'pruning.powerLow': { min: 0, max: 3 },
  'pruning.powerHigh': { min: 0, max: 3 },
  'bark.grain': { min: 0.01, max: 1 },
  'foliage.size': { min: 0.1, max: 3 },
  'wind.flutter': { min: 0, max: 60 },
  'wind.flutterRate': { min: 0, max: 8 },
  'wind.modulus': { min: 0.5, max: 15 },
  'wind.density': { min: 300, max: 1200 },
  'wind.leafMass': { min: 0, max: 0.6 },
  'wind.damping': { min: 0.2, max: 3 },
};

/** Ends that a slider takes to hold a value beyond them: a little further, so that it can go on. */
const beyond = (value: number, step: number): number => Math.ceil(Math.abs(value) / step / 10) * step * 10;

/** What the slider of a parameter reaches so that all of `values` lie on it; never beyond what is allowed. */
export function sliderRange(parameter: NumberParameter, values: readonly (number | undefined)[]): Range {
  const { min, max, step } = parameter;
  const comfort = COMFORT[`${parameter.group}.${parameter.key}`] ?? { min, max };
  let low = comfort.min;
  let high = comfort.max;
  for (const value of values) {
    if (value === undefined) continue;
    // Stretched to what rounds outwards; digits of the step, no rounding errors of the product.
    if (value < low) low = value < 0 ? -Number(beyond(value, step).toFixed(6)) : 0;
    if (value > high) high = Number(beyond(value, step).toFixed(6));
  }
  return { min: Math.max(min, low), max: Math.min(max, high) };
}
