/** How far a parameter of a species may differ from tree to tree. */
export interface Width {
  /** Key beside it whose value is that variation, where the species has one. */
  readonly by?: string;
  /** Part of that variation that is taken; 1 where absent. */
  readonly share?: number;
  /** Part of the parameter's own value, where it has no variation: what is 0 stays 0, a thing that the species does not have. */
  readonly part?: number;
}

/**
 * Widths of what makes one tree of a species differ from another, by group and key. What is not here is what the species is: its shape, its
 * levels, the outline of its leaves, its readings of the paper.
 */
export const WIDTHS: Readonly<Record<string, Width>> = {
  'tree.baseSize': { part: 0.2 },
  'tree.scale': { by: 'scaleV', part: 0.06 },
  'tree.zScale': { by: 'zScaleV', part: 0.04 },
  'tree.ratio': { part: 0.15 },
  'tree.ratioPower': { part: 0.05 },
  'tree.lobeDepth': { part: 0.3 },
  'tree.flare': { part: 0.3 },
  'tree.attractionUp': { part: 0.25 },
  'tree.disc': { part: 0.2 },
  'tree.bulgeDepth': { part: 0.3 },
  'levels.scale': { by: 'scaleV', part: 0.05 },
  'levels.length': { by: 'lengthV', part: 0.08 },
  'levels.lengthV': { part: 0.2 },
  'levels.segSplits': { part: 0.1 },
  'levels.splitAngle': { by: 'splitAngleV', part: 0.1 },
  'levels.splitAngleV': { part: 0.2 },
  // The variation of a curve is that of all its segments together; one tree does not lean all its branches that far.
  'levels.curve': { by: 'curveV', share: 0.25, part: 0.1 },
  'levels.curveBack': { part: 0.15 },
  'levels.curveV': { part: 0.15 },
  'levels.curveSideV': { part: 0.15 },
  'levels.helixTurns': { part: 0.1 },
  'levels.downAngle': { by: 'downAngleV', part: 0.1 },
  'levels.downAngleV': { part: 0.15 },
  'levels.rotate': { by: 'rotateV', part: 0.03 },
  'levels.rotateV': { part: 0.2 },
  'levels.branches': { part: 0.12 },
  'leaves.count': { part: 0.12 },
  'leaves.scale': { part: 0.08 },
  'leaves.scaleX': { part: 0.06 },
  'leaves.petiole': { part: 0.15 },
  'leaves.bend': { part: 0.15 },
  'leaves.flat': { part: 0.15 },
  'leaves.downAngle': { by: 'downAngleV', part: 0.1 },
  'leaves.rotate': { by: 'rotateV', part: 0.03 },
  'pruning.width': { part: 0.1 },
  'pruning.widthPeak': { part: 0.1 },
  'pruning.powerLow': { part: 0.15 },
  'pruning.powerHigh': { part: 0.15 },
  'bark.grain': { part: 0.15 },
  'wind.stiffness': { part: 0.1 },
  'wind.modulus': { part: 0.08 },
  'wind.leafMass': { part: 0.1 },
  'wind.damping': { part: 0.1 },
};

/** How far colours differ at most, in OKLab: lightness, and each of the two axes. */
export const COLOUR_WIDTH = { lightness: 0.035, hue: 0.018 } as const;

/** Colours that differ together: the faces of one leaf, the ridges and furrows of one bark. */
export const COLOURS: readonly string[] = [
  'bark.colour',
  'bark.dark',
  'foliage.colour',
  'foliage.under',
  'foliage.glow',
];

/** Numbers below 0 that mean something else than those above (a fan, alternate sides, a helix): a change never crosses 0. */
export const SIGN_IS_A_FLAG: ReadonlySet<string> = new Set([
  'levels.curveV',
  'levels.downAngleV',
  'levels.rotate',
  'levels.branches',
  'leaves.count',
  'leaves.downAngleV',
  'leaves.rotate',
]);
