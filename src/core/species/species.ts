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
  /** What it is and how one tells it, one paragraph; '' where the file says nothing. */
  readonly description: string;
  /** What a botanist measures on grown trees of the kind; absent in files that say nothing of it. */
  readonly facts?: SpeciesFacts;
  readonly tree: TreeParameters;
  /** Levels 0 (trunk) to 3; deeper levels use the last. */
  readonly levels: readonly LevelParameters[];
  readonly leaves: LeafParameters;
  readonly pruning: PruningParameters;
  readonly switches: SpeciesSwitches;
  readonly bark: BarkLook;
  readonly foliage: FoliageLook;
  readonly organ: OrganLook;
  /** What the other seasons change; the file's own look is that of summer. */
  readonly spring: SeasonLook;
  readonly autumn: SeasonLook;
  readonly winter: SeasonLook;
  readonly wind: WindAnswer;
}

export const SPECIES_KINDS = ['broadleaf', 'conifer', 'palm', 'shrub', 'grass', 'fern', 'succulent', 'bare'] as const;
export type SpeciesKind = (typeof SPECIES_KINDS)[number];

/** Least and most of something. */
export type Range = readonly [least: number, most: number];

/** Measures of grown trees of a kind, and who took them. */
export interface SpeciesFacts {
  readonly kind: SpeciesKind;
  /** Metres. */
  readonly height: Range;
  /** Width of the crown as a part of the height. */
  readonly spread: Range;
  /** Part of the height below the crown's first branches. */
  readonly clear: Range;
  /** Where it grows by itself. */
  readonly range: string;
  readonly source: string;
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
  /** Lobes of the cross-section of branches, as `tree.lobes` has them of the trunk: arms of a cactus. Level 0 does not read them. */
  readonly lobes: number;
  readonly lobeDepth: number;
}

export interface LeafParameters {
  readonly count: number;
  /** Index of LEAF_SHAPES (parameters-leaf.ts): 0 to 5 are the paper's. */
  readonly shape: number;
  readonly scale: number;
  readonly scaleX: number;
  /** Length of the petiole as a fraction of the blade's. */
  readonly petiole: number;
  readonly bend: number;
  /**
   * How far leaves stand in two rows and lie in the plane of their stem and its parent, 0..1, as on fronds and sprays; absent: 0.
   * The plane is that of the stem's y and z, which is the spray's where rows of stems stand on alternate sides (row 15).
   */
  readonly flat?: number;
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

export const BARK_KINDS = ['smooth', 'furrowed', 'plated', 'peeling', 'stringy', 'palm', 'ribbed', 'noded'] as const;
export type BarkKind = (typeof BARK_KINDS)[number];

export interface BarkLook {
  readonly kind: BarkKind;
  /** sRGB, '#rrggbb': ridges, and the depth of furrows and marks. */
  readonly colour: string;
  readonly dark: string;
  /** Size of the pattern in metres. */
  readonly grain: number;
  readonly roughness: number;
  /** Depth of the relief, 0..1. */
  readonly relief: number;
  /** How far ridges stand out of the stem where one is near, metres. */
  readonly depth: number;
  /** Colour of twigs; absent: between the two. */
  readonly young?: string;
  /** Radius in metres at which the bark of twigs has become that of old wood. */
  readonly youngRadius: number;
  /** How much of the stem moss covers, from the foot and the shaded side on, and lichen, in patches; 0..1. */
  readonly moss: number;
  readonly mossColour: string;
  readonly lichen: number;
  readonly lichenColour: string;
}

export interface FoliageLook {
  /** Outline that is drawn in place of `leaves.shape`, same ids; absent: `leaves.shape`. */
  readonly outline?: number;
  /** Free outline in place of a shape: half widths of the blade, 0..1 of half its width, at even steps from base to tip. */
  readonly margin?: readonly number[];
  /** Drawn length of a blade as a part of `leaves.scale`, where the printed leaf is too small for its tree. */
  readonly size: number;
  /** sRGB, '#rrggbb': upper face, lower face, and light that comes through. */
  readonly colour: string;
  readonly under: string;
  readonly glow: string;
  /** A second colour of the upper face and the part of the leaves that are on their way to it: what an autumn ramps to. */
  readonly second?: string;
  readonly secondShare: number;
  /** How much the colour varies from leaf to leaf, 0..1. */
  readonly variation: number;
  readonly roughness: number;
  /** How much light a blade holds back, 0..1: 0 a thin leaf that glows, 1 one that lets nothing through. */
  readonly thickness: number;
  /** How strongly veins show, 0..1. */
  readonly veins: number;
  /** Part of the leaves that are there, 0..1. */
  readonly cover: number;
}

export const ORGAN_KINDS = ['none', 'blossom', 'fruit', 'cone', 'catkin'] as const;
export type OrganKind = (typeof ORGAN_KINDS)[number];

/** What twigs bear besides leaves, at the places of some of them. */
export interface OrganLook {
  readonly kind: OrganKind;
  /** Part of the places of leaves at which one stands, 0..1. */
  readonly share: number;
  /** Metres across (blossom, fruit) or along (cone, catkin). */
  readonly size: number;
  /** sRGB, '#rrggbb': petals, skin or scales; their middle, stalk or gaps. */
  readonly colour: string;
  readonly second: string;
}

/** What a season changes of foliage and organs; what is absent is as in summer. */
export interface SeasonLook {
  readonly cover?: number;
  readonly colour?: string;
  readonly second?: string;
  readonly secondShare?: number;
  readonly under?: string;
  readonly glow?: string;
  readonly organ?: OrganKind;
  readonly organShare?: number;
  readonly organSize?: number;
  readonly organColour?: string;
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
  /** Damping ratio of its stems over that of the wind document, > 0: the inner friction of its wood, and the drag of what it bears. */
  readonly damping: number;
}
