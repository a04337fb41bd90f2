/** Where each of Arbaro's parameters of the whole tree goes, by its name, which is that of Weber & Penn's paper. */
const TREE: Readonly<Record<string, string>> = {
  Shape: 'tree.shape',
  Levels: 'tree.levels',
  Scale: 'tree.scale',
  ScaleV: 'tree.scaleV',
  ZScale: 'tree.zScale',
  ZScaleV: 'tree.zScaleV',
  BaseSize: 'tree.baseSize',
  Ratio: 'tree.ratio',
  RatioPower: 'tree.ratioPower',
  Lobes: 'tree.lobes',
  LobeDepth: 'tree.lobeDepth',
  Flare: 'tree.flare',
  AttractionUp: 'tree.attractionUp',
  '0Scale': 'levels.0.scale',
  '0ScaleV': 'levels.0.scaleV',
  '0BaseSplits': 'levels.0.baseSplits',
  Leaves: 'leaves.count',
  LeafCount: 'leaves.count',
  LeafScale: 'leaves.scale',
  LeafScaleX: 'leaves.scaleX',
  LeafStemLen: 'leaves.petiole',
  LeafBend: 'leaves.bend',
  LeafQuality: 'leaves.quality',
  PruneRatio: 'pruning.ratio',
  PruneWidth: 'pruning.width',
  PruneWidthPeak: 'pruning.widthPeak',
  PrunePowerLow: 'pruning.powerLow',
  PrunePowerHigh: 'pruning.powerHigh',
};

/** The same for those that every level has: `1Length` is `levels.1.length`. */
const LEVEL: Readonly<Record<string, string>> = {
  Length: 'length',
  LengthV: 'lengthV',
  Taper: 'taper',
  SegSplits: 'segSplits',
  SplitAngle: 'splitAngle',
  SplitAngleV: 'splitAngleV',
  CurveRes: 'curveRes',
  Curve: 'curve',
  CurveBack: 'curveBack',
  CurveV: 'curveV',
  DownAngle: 'downAngle',
  DownAngleV: 'downAngleV',
  Rotate: 'rotate',
  RotateV: 'rotateV',
  Branches: 'branches',
};

/** Those of a level that stand for nothing at the trunk here, which has no parent. */
const OF_BRANCHES = ['DownAngle', 'DownAngleV', 'Rotate', 'RotateV'];

/** Those that have no counterpart here, and the value at which they do nothing. */
const WITHOUT_COUNTERPART: Readonly<Record<string, number>> = {
  Smooth: Number.NaN,
  LeafDistrib: Number.NaN,
  BranchDist: 0,
};

/** What becomes of a parameter of Arbaro: it goes to a path, or to none though it is known; undefined where it is unknown. */
export type Destination = { readonly path: string } | { readonly idle: number };

/** Where the parameter of that name goes. */
export function destinationOf(name: string): Destination | undefined {
  if (Object.hasOwn(TREE, name)) return { path: TREE[name]! };
  if (Object.hasOwn(WITHOUT_COUNTERPART, name)) return { idle: WITHOUT_COUNTERPART[name]! };
  const [, digit, key] = /^([0-3])([A-Z][A-Za-z]*)$/.exec(name) ?? [];
  if (digit === undefined || key === undefined) return undefined;
  if (Object.hasOwn(WITHOUT_COUNTERPART, key)) return { idle: WITHOUT_COUNTERPART[key]! };
  if (!Object.hasOwn(LEVEL, key)) return undefined;
  return digit === '0' && OF_BRANCHES.includes(key) ? { idle: 0 } : { path: `levels.${digit}.${LEVEL[key]}` };
}

/** Arbaro's leaf shapes by name, as far as the paper's shapes have the like: the paper's ids. */
export const LEAF_SHAPE_IDS: Readonly<Record<string, number>> = {
  '0': 0,
  '1': 1,
  '2': 2,
  '3': 3,
  '4': 4,
  '5': 5,
  disc: 0,
  triangle: 1,
  oak: 2,
  maple: 4,
};
