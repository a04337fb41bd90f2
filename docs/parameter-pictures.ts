import type { ParameterValue, SpeciesEdits } from '../src/core/species/edits.ts';

/** Where a picture is taken from. */
export type PictureView =
  /** The whole tree, from the side. */
  | 'whole'
  /** The foot of the trunk, up to a tenth of the tree. */
  | 'foot'
  /** The trunk from the ground to the crown. */
  | 'trunk'
  /** From straight above. */
  | 'above'
  /** A limb about half way up, some metres wide. */
  | 'limb'
  /** A spray of twigs and leaves, about a metre wide. */
  | 'spray'
  /** A few leaves, about a third of a metre wide. */
  | 'leaf'
  /** Half a metre of bark at breast height. */
  | 'bark';

/** Two pictures of one tree that differ in one parameter. */
export interface ParameterPicture {
  /** Without the level, as the pictures are named: `levels.downAngle` gives help/levels.downAngle-low.webp and -high.webp. */
  readonly path: string;
  /** Level whose parameter it is, where the path is one of `levels`. */
  readonly level?: number;
  readonly species: string;
  readonly seed: number;
  readonly low: ParameterValue;
  readonly high: ParameterValue;
  readonly view: PictureView;
  /** Draw leaves, and stems of these levels alone (1: the trunk). */
  readonly leaves: boolean;
  readonly levelsShown?: number;
  /** What both pictures need so that the parameter is seen. */
  readonly edits?: SpeciesEdits;
}

const ASPEN = { species: 'quaking-aspen', seed: 3 } as const;
const OAK = { species: 'california-black-oak', seed: 4 } as const;
const TUPELO = { species: 'black-tupelo', seed: 2 } as const;
const MAPLE = { species: 'sugar-maple', seed: 1 } as const;
const CHERRY = { species: 'cherry', seed: 1 } as const;
const CACTUS = { species: 'saguaro-cactus', seed: 1 } as const;
const WILLOW = { species: 'weeping-willow', seed: 1 } as const;

type Rest = Omit<ParameterPicture, 'path' | 'low' | 'high' | 'view' | 'leaves'> & { readonly leaves?: boolean };

const pair = (
  path: string,
  low: ParameterValue,
  high: ParameterValue,
  view: PictureView,
  rest: Rest,
): ParameterPicture => ({
  path,
  low,
  high,
  view,
  leaves: false,
  ...rest,
});

const LIMBS = { level: 1, levelsShown: 2 } as const;
const TRUNK = { level: 0, levelsShown: 1 } as const;

/**
 * What the help shows of each parameter: little and much of it, on the species that shows it best.
 *
 * No picture has what cannot be seen in one: what changes only the motion (`wind`), and readings of the paper that hardly differ.
 */
export const PARAMETER_PICTURES: readonly ParameterPicture[] = [
  pair('tree.shape', 0, 6, 'whole', { ...ASPEN, leaves: true }),
  pair('tree.crown', [1, 0.75, 0.5, 0.3, 0.1], [0.15, 0.5, 1, 0.9, 0.3], 'whole', { ...ASPEN, leaves: true }),
  pair('tree.baseSize', 0.1, 0.6, 'whole', { ...ASPEN, leaves: true }),
  pair('tree.scale', 6, 16, 'whole', { ...ASPEN, leaves: true, edits: { 'tree.scaleV': 0 } }),
  pair('tree.zScale', 0.6, 1.5, 'whole', { ...ASPEN, leaves: true }),
  pair('tree.levels', 2, 3, 'whole', { ...ASPEN }),
  pair('tree.ratio', 0.008, 0.04, 'whole', { ...ASPEN, levelsShown: 2 }),
  pair('tree.ratioPower', 0.7, 2, 'limb', { ...ASPEN }),
  pair('tree.lobes', 3, 9, 'foot', { ...ASPEN, edits: { 'tree.lobeDepth': 0.2 } }),
  pair('tree.lobeDepth', 0, 0.3, 'foot', { ...ASPEN }),
  pair('tree.flare', 0, 2, 'foot', { ...ASPEN, edits: { 'tree.lobes': 0 } }),
  pair('tree.attractionUp', -3, 3, 'whole', { ...TUPELO }),
  pair('tree.bulges', 4, 16, 'trunk', {
    ...ASPEN,
    levelsShown: 1,
    edits: { 'tree.bulgeDepth': 0.3, 'tree.ratio': 0.06 },
  }),
  pair('tree.bulgeDepth', 0, 0.4, 'trunk', {
    ...ASPEN,
    levelsShown: 1,
    edits: { 'tree.bulges': 10, 'tree.ratio': 0.06 },
  }),

  pair('levels.scale', 0.5, 2, 'whole', { ...ASPEN, level: 0, levelsShown: 2 }),
  pair('levels.length', 0.15, 0.55, 'whole', { ...ASPEN, ...LIMBS }),
  pair('levels.lengthV', 0, 0.2, 'whole', { ...ASPEN, ...LIMBS }),
  pair('levels.taper', 0, 1, 'trunk', { ...ASPEN, ...TRUNK, edits: { 'tree.ratio': 0.03 } }),
  pair('levels.baseSplits', 0, 3, 'whole', {
    ...ASPEN,
    level: 0,
    levelsShown: 2,
    edits: { 'levels.0.splitAngle': 20, 'levels.0.curveRes': 8 },
  }),
  pair('levels.segSplits', 0, 1, 'whole', {
    ...ASPEN,
    ...TRUNK,
    edits: { 'levels.0.splitAngle': 20, 'levels.0.curveRes': 5 },
  }),
  pair('levels.splitAngle', 8, 45, 'whole', {
    ...ASPEN,
    ...TRUNK,
    edits: { 'levels.0.segSplits': 0.6, 'levels.0.curveRes': 6 },
  }),
  pair('levels.splitAngleV', 0, 30, 'whole', {
    ...ASPEN,
    ...TRUNK,
    edits: { 'levels.0.segSplits': 0.6, 'levels.0.curveRes': 6, 'levels.0.splitAngle': 25 },
  }),
  pair('levels.curveRes', 3, 16, 'whole', {
    ...ASPEN,
    ...LIMBS,
    edits: { 'levels.1.curve': -110, 'levels.1.curveV': 0, 'levels.1.length': 0.5 },
  }),
  pair('levels.curve', -80, 80, 'whole', {
    ...ASPEN,
    ...LIMBS,
    edits: { 'levels.1.curveRes': 10, 'levels.1.curveV': 0 },
  }),
  pair('levels.curveBack', -90, 90, 'whole', {
    ...ASPEN,
    ...LIMBS,
    edits: { 'levels.1.curve': 30, 'levels.1.curveRes': 12, 'levels.1.curveV': 0, 'levels.1.length': 0.5 },
  }),
  pair('levels.curveV', 0, 200, 'whole', { ...ASPEN, ...LIMBS, edits: { 'levels.1.curveRes': 12 } }),
  pair('levels.curveSideV', 0, 200, 'whole', {
    ...ASPEN,
    ...LIMBS,
    edits: { 'levels.1.curveRes': 12, 'levels.1.curveV': 0 },
  }),
  pair('levels.helixTurns', 0.1, 0.5, 'trunk', {
    ...ASPEN,
    ...TRUNK,
    edits: { 'levels.0.curveV': -35, 'levels.0.curveRes': 8 },
  }),
  pair('levels.downAngle', 25, 110, 'whole', {
    ...ASPEN,
    ...LIMBS,
    edits: { 'levels.1.downAngleV': 0, 'levels.1.curve': 0 },
  }),
  pair('levels.downAngleV', -60, 40, 'whole', { ...ASPEN, ...LIMBS, edits: { 'levels.1.curve': 0 } }),
  pair('levels.rotate', -90, 140, 'above', { ...ASPEN, ...LIMBS, edits: { 'tree.ratio': 0.03 } }),
  pair('levels.rotateV', 0, 60, 'above', { ...ASPEN, ...LIMBS, edits: { 'levels.1.rotate': 180, 'tree.ratio': 0.03 } }),
  pair('levels.branches', 12, 80, 'whole', { ...ASPEN, ...LIMBS }),
  pair('levels.lobes', 4, 14, 'trunk', { ...CACTUS, level: 1, edits: { 'levels.1.lobeDepth': 0.3 } }),
  pair('levels.lobeDepth', 0, 0.4, 'trunk', { ...CACTUS, level: 1, edits: { 'levels.1.lobes': 8 } }),

  pair('leaves.count', 6, 50, 'whole', { ...ASPEN, leaves: true }),
  pair('leaves.shape', 0, 4, 'leaf', { ...ASPEN, leaves: true, edits: { 'foliage.outline': null } }),
  pair('leaves.scale', 0.08, 0.35, 'spray', { ...ASPEN, leaves: true }),
  pair('leaves.scaleX', 0.25, 1.2, 'leaf', { ...ASPEN, leaves: true }),
  pair('leaves.petiole', 0, 1.5, 'leaf', { ...ASPEN, leaves: true }),
  pair('leaves.bend', 0, 1, 'spray', { ...ASPEN, leaves: true }),
  pair('leaves.flat', 0, 1, 'spray', { ...ASPEN, leaves: true, edits: { 'leaves.bend': 0 } }),
  pair('leaves.quality', 0.2, 2, 'whole', { ...ASPEN, leaves: true }),
  pair('leaves.downAngle', 10, 100, 'spray', { ...ASPEN, leaves: true, edits: { 'leaves.bend': 0 } }),
  pair('leaves.rotate', -90, 77, 'spray', { ...ASPEN, leaves: true, edits: { 'leaves.bend': 0 } }),

  pair('pruning.ratio', 0, 1, 'whole', {
    ...ASPEN,
    leaves: true,
    edits: { 'pruning.width': 0.14, 'pruning.widthPeak': 0.4 },
  }),
  pair('pruning.width', 0.08, 0.2, 'whole', { ...ASPEN, leaves: true, edits: { 'pruning.ratio': 1 } }),
  pair('pruning.widthPeak', 0.15, 0.85, 'whole', {
    ...ASPEN,
    leaves: true,
    edits: { 'pruning.ratio': 1, 'pruning.width': 0.18 },
  }),
  pair('pruning.powerLow', 0.1, 2, 'whole', { ...WILLOW, leaves: true }),
  pair('pruning.powerHigh', 0.1, 2, 'whole', {
    ...ASPEN,
    leaves: true,
    edits: { 'pruning.ratio': 1, 'pruning.width': 0.2, 'pruning.widthPeak': 0.3 },
  }),

  pair('switches.branchesAboveBase', false, true, 'whole', { ...ASPEN, levelsShown: 2 }),
  pair('switches.halveCloning', false, true, 'whole', { ...OAK, levelsShown: 2 }),

  pair('bark.kind', 'smooth', 'plated', 'bark', { ...TUPELO }),
  pair('bark.colour', '#d9dac6', '#6b4a33', 'bark', { ...ASPEN }),
  pair('bark.dark', '#8a8474', '#15110d', 'bark', { ...TUPELO }),
  pair('bark.grain', 0.06, 0.4, 'bark', { ...TUPELO }),
  pair('bark.roughness', 0.2, 1, 'bark', { ...ASPEN }),
  pair('bark.relief', 0, 1, 'bark', { ...TUPELO }),
  pair('bark.depth', 0, 0.03, 'bark', { ...TUPELO }),
  pair('bark.young', '#6b2f2a', '#8fa25a', 'limb', { ...ASPEN, edits: { 'bark.youngRadius': 0.08 } }),
  pair('bark.youngRadius', 0.01, 0.12, 'limb', { ...ASPEN, edits: { 'bark.young': '#6b2f2a' } }),
  pair('bark.moss', 0, 0.9, 'bark', { ...TUPELO }),
  pair('bark.mossColour', '#3f4f1e', '#a3a84a', 'bark', { ...TUPELO, edits: { 'bark.moss': 0.8 } }),
  pair('bark.lichen', 0, 0.8, 'bark', { ...TUPELO }),
  pair('bark.lichenColour', '#8fa3a0', '#d9b24a', 'bark', { ...TUPELO, edits: { 'bark.lichen': 0.6 } }),

  pair('foliage.outline', 1, 2, 'leaf', { ...OAK, leaves: true }),
  pair('foliage.size', 0.6, 1.8, 'spray', { ...ASPEN, leaves: true }),
  pair('foliage.colour', '#3f6b24', '#c9962b', 'whole', { ...ASPEN, leaves: true }),
  pair('foliage.under', '#5c7443', '#e3e8d6', 'leaf', { ...ASPEN, leaves: true }),
  pair('foliage.glow', '#5f7a2a', '#ffe46b', 'spray', { ...ASPEN, leaves: true }),
  pair('foliage.variation', 0, 1, 'whole', { ...ASPEN, leaves: true }),
  pair('foliage.roughness', 0.1, 1, 'leaf', { ...ASPEN, leaves: true }),
  pair('foliage.margin', [0, 1, 0.8, 0.3, 0], [0.2, 0.5, 0.7, 1, 0.1], 'leaf', { ...ASPEN, leaves: true }),
  pair('foliage.second', '#e0b321', '#b3262b', 'whole', {
    ...MAPLE,
    leaves: true,
    edits: { 'foliage.secondShare': 0.5 },
  }),
  pair('foliage.secondShare', 0.1, 0.9, 'whole', { ...MAPLE, leaves: true, edits: { 'foliage.second': '#d9822b' } }),
  pair('foliage.thickness', 0, 1, 'spray', { ...ASPEN, leaves: true }),
  pair('foliage.veins', 0, 1, 'leaf', { ...ASPEN, leaves: true }),
  pair('foliage.cover', 0.2, 1, 'whole', { ...ASPEN, leaves: true }),

  pair('organ.kind', 'blossom', 'fruit', 'leaf', {
    ...CHERRY,
    leaves: true,
    edits: { 'organ.share': 0.6, 'foliage.cover': 0.4 },
  }),
  pair('organ.share', 0.1, 0.8, 'leaf', {
    ...CHERRY,
    leaves: true,
    edits: { 'organ.kind': 'blossom', 'foliage.cover': 0.4 },
  }),
  pair('organ.size', 0.015, 0.05, 'leaf', {
    ...CHERRY,
    leaves: true,
    edits: { 'organ.kind': 'fruit', 'organ.share': 0.6, 'foliage.cover': 0.4 },
  }),
  pair('organ.colour', '#f4e3e6', '#c4203a', 'leaf', {
    ...CHERRY,
    leaves: true,
    edits: { 'organ.kind': 'fruit', 'organ.share': 0.6, 'foliage.cover': 0.4 },
  }),
  pair('organ.second', '#e8c33a', '#6d2a3c', 'leaf', {
    ...CHERRY,
    leaves: true,
    edits: { 'organ.kind': 'blossom', 'organ.share': 0.6, 'organ.size': 0.05 },
  }),

  // One picture for all seasons: they change the same.
  pair('autumn.cover', 0.15, 1, 'whole', { ...MAPLE, leaves: true }),
  pair('autumn.colour', '#d9a521', '#b3261e', 'whole', { ...MAPLE, leaves: true, edits: { 'autumn.secondShare': 0 } }),
  pair('autumn.second', '#e0c021', '#7d1a24', 'whole', {
    ...MAPLE,
    leaves: true,
    edits: { 'autumn.secondShare': 0.6 },
  }),
  pair('autumn.secondShare', 0.05, 0.9, 'whole', {
    ...MAPLE,
    leaves: true,
    edits: { 'autumn.colour': '#7c9a3a', 'autumn.second': '#c23b22' },
  }),
  pair('autumn.under', '#6f6a2c', '#e5c98a', 'leaf', { ...MAPLE, leaves: true }),
  pair('autumn.glow', '#8a5a1c', '#ffd34a', 'spray', { ...MAPLE, leaves: true }),
  pair('autumn.organ', 'none', 'fruit', 'leaf', {
    ...CHERRY,
    leaves: true,
    edits: { 'autumn.cover': 0.4, 'autumn.organShare': 0.6, 'autumn.organColour': '#8e1430' },
  }),
  pair('autumn.organShare', 0.1, 0.8, 'leaf', {
    ...CHERRY,
    leaves: true,
    edits: { 'autumn.cover': 0.4, 'autumn.organ': 'fruit', 'autumn.organColour': '#8e1430' },
  }),
  pair('autumn.organSize', 0.012, 0.045, 'leaf', {
    ...CHERRY,
    leaves: true,
    edits: { 'autumn.cover': 0.4, 'autumn.organ': 'fruit', 'autumn.organShare': 0.6, 'autumn.organColour': '#8e1430' },
  }),
  pair('autumn.organColour', '#e0a52c', '#8e1430', 'leaf', {
    ...CHERRY,
    leaves: true,
    edits: { 'autumn.cover': 0.4, 'autumn.organ': 'fruit', 'autumn.organShare': 0.6 },
  }),
];

/** The path of a picture's parameter in a species. */
export const placeOf = ({ path, level }: ParameterPicture): string =>
  level === undefined ? path : path.replace('levels.', `levels.${level}.`);

/** What `public/help/index.json` holds: the values that the pictures show, for those that are there. The page reads it. */
export const pictureIndex = (
  there: (path: string) => boolean,
): Readonly<Record<string, { readonly low: ParameterValue; readonly high: ParameterValue }>> =>
  Object.fromEntries(
    PARAMETER_PICTURES.filter(({ path }) => there(path)).map(({ path, low, high }) => [path, { low, high }]),
  );
