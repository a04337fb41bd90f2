/**
 * A species as its file says it: the parameters of Weber & Penn 1995, appendix, in the paper's units (metres, degrees,
 * fractions), what it looks like and how it answers the wind. The parameter table (`parameters.ts`) has the unit, range
 * and meaning of every number here.
 */
export interface Species {
  readonly format: 'windgrove-species';
  readonly version: 1;
  readonly name: string;
  readonly latin: string;
  /** Where the numbers come from. */
  readonly source: string;
  readonly tree: TreeParameters;
  /** Levels 0 (trunk) to 3; deeper levels use the last. */
  readonly levels: readonly LevelParameters[];
  readonly leaves: LeafParameters;
  readonly pruning: PruningParameters;
  readonly switches: SpeciesSwitches;
  readonly bark: BarkLook;
  readonly foliage: FoliageLook;
  readonly wind: WindAnswer;
}

export interface TreeParameters {
  readonly shape: number;
  /**
   * Lengths of the main branches in place of ShapeRatio(`shape`), 2 to 8 numbers 0..1 at even steps from the base of the crown to the
   * top; absent: `shape` alone.
   */
  readonly crown?: readonly number[];
  readonly baseSize: number;
  readonly scale: number;
  readonly scaleV: number;
  readonly zScale: number;
  readonly zScaleV: number;
  readonly levels: number;
  readonly ratio: number;
  readonly ratioPower: number;
  readonly lobes: number;
  readonly lobeDepth: number;
  readonly flare: number;
  readonly attractionUp: number;
  /** Radius of the disc in which several trunks stand, as a fraction of the tree's scale (row 52). */
  readonly disc: number;
  /** Bulges along every stem: how many, and their depth as a fraction of the radius (Skjermo 2006, equation 4). */
  readonly bulges: number;
  readonly bulgeDepth: number;
}

/** Level 0 alone reads `scale`, `scaleV`, `baseSplits`; its `branches` is the number of trunks, 1 where it is 0. */
export interface LevelParameters {
  readonly scale: number;
  readonly scaleV: number;
  readonly length: number;
  readonly lengthV: number;
  readonly taper: number;
  readonly baseSplits: number;
  readonly segSplits: number;
  readonly splitAngle: number;
  readonly splitAngleV: number;
  readonly curveRes: number;
  readonly curve: number;
  readonly curveBack: number;
  readonly curveV: number;
  readonly curveSideV: number;
  /** Turns a segment of a helix (curveV < 0). */
  readonly helixTurns: number;
  readonly downAngle: number;
  readonly downAngleV: number;
  readonly rotate: number;
  readonly rotateV: number;
  readonly branches: number;
}

export interface LeafParameters {
  readonly count: number;
  /** 0 oval, 1 triangle, 2 three-lobed oak, 3 three-lobed maple, 4 five-lobed maple, 5 three leaflets. */
  readonly shape: number;
  readonly scale: number;
  readonly scaleX: number;
  /** Length of the petiole as a fraction of the blade's. */
  readonly petiole: number;
  readonly bend: number;
  readonly quality: number;
  /** Angles of the leaves alone, in degrees; each one that is absent is that of level `levels`, at most 3 (row 42). */
  readonly downAngle?: number;
  readonly downAngleV?: number;
  readonly rotate?: number;
  readonly rotateV?: number;
}

export interface PruningParameters {
  readonly ratio: number;
  readonly width: number;
  readonly widthPeak: number;
  readonly powerLow: number;
  readonly powerHigh: number;
}

/** Readings of the paper that a species chooses between; all false (and 0.75) is Windgrove's own (weber-penn.md, section 2). */
export interface SpeciesSwitches {
  /** The printed form of rows 5, 31 and 38, whatever their own switches say. */
  readonly paper: boolean;
  /** Row 5: grow all 1Branches above the bare part. */
  readonly branchesAboveBase: boolean;
  /** Row 31: each clone halves the propensity to form further clones. */
  readonly halveCloning: boolean;
  /** Row 38: the printed form of the vertical attraction. */
  readonly paperAttraction: boolean;
  /** Row 48: cut stems that droop under the envelope too. */
  readonly pruneBase: boolean;
  /** Row 35: factor of the divergence about the vertical. */
  readonly spread: number;
}

export interface BarkLook {
  readonly kind: 'smooth' | 'furrowed' | 'plated';
  /** sRGB, '#rrggbb': ridges, and the depth of furrows and marks. */
  readonly colour: string;
  readonly dark: string;
  /** Size of the pattern in metres. */
  readonly grain: number;
  readonly roughness: number;
  /** Depth of the relief, 0..1. */
  readonly relief: number;
}

export interface FoliageLook {
  /** Outline that is drawn in place of `leaves.shape`, same ids; absent: `leaves.shape`. */
  readonly outline?: number;
  /** Drawn length of a blade as a part of `leaves.scale`, where the printed leaf is too small for its tree. */
  readonly size: number;
  /** sRGB, '#rrggbb': upper face, lower face, and light that comes through. */
  readonly colour: string;
  readonly under: string;
  readonly glow: string;
  /** How much the colour varies from leaf to leaf, 0..1. */
  readonly variation: number;
  readonly roughness: number;
}

export interface WindAnswer {
  /** Stiffness of each level, > 0; the bend of a stem is divided by it. */
  readonly stiffness: readonly number[];
  /** Flutter of the leaves: angle in degrees at a force of 1, and rate in hertz. */
  readonly flutter: number;
  readonly flutterRate: number;
  /** Young's modulus of the green wood in GPa, its density in kg/m^3 and the mass of the leaves in kg/m^2: how fast stems swing. */
  readonly modulus: number;
  readonly density: number;
  readonly leafMass: number;
}
