/** One wave of the wind (Skjermo 2007, equation 11, corrected). */
export interface Wave {
  on: boolean;
  /** Displacement in metres that the crest gives to the tip edge of a stem of 3 m and stiffness 1 at right angles to it; >= 0. */
  amplitude: number;
  /** Direction towards which it travels and pushes, radians from x to y in tree space. */
  direction: number;
  /** Metres, > 0. */
  wavelength: number;
  /** Metres a second, >= 0. */
  speed: number;
  /** Exponent k of ((1 + sin)/2)^k, > 0: the larger, the shorter the gust. */
  sharpness: number;
  /** Phase in turns at time 0 and at the origin: changing `speed` at time t changes it, so that nothing jumps. */
  phase: number;
}

/** A wind document: what the wind is, without time. */
export interface Wind {
  /** Name to show. */
  name: string;
  /** Factor on all waves, 0 (still) to 1. */
  strength: number;
  /** Four, as in the paper. */
  waves: Wave[];
  /** Bend model. */
  model: 'direct';
  /** `exact`: depth by depth without lag. `lagged`: the paper, parents from the last step. */
  pose: 'exact' | 'lagged';
  /** Exponent p of the force (equation 16 prints 1.8; 1 is dimensionally sound). */
  forceExponent: number;
  /**
   * Exponent m of the length (a third of the stem's, metres) that divides the force (equations.md 5.3): 2 is the literal paper, 1 makes
   * amplitudes displacements, 0.6 is a cantilever's and the presets'.
   */
  lengthExponent: number;
  /** The printed forms that make sense, for teaching: waves that travel upwind, no length kept, projected frames. */
  paper: boolean;
}
