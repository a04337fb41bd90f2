import { type GrownPacked, growPacked } from '../../core/pack/grow-packed.ts';
import { parseSpecies } from '../../core/species/parse.ts';
import type { Species } from '../../core/species/species.ts';

const STEM = {
  scale: 1,
  scaleV: 0,
  length: 1,
  lengthV: 0,
  taper: 1,
  baseSplits: 0,
  segSplits: 0,
  splitAngle: 0,
  splitAngleV: 0,
  curveRes: 5,
  curve: 0,
  curveBack: 0,
  curveV: 0,
  curveSideV: 0,
  helixTurns: 0.5,
  downAngle: 0,
  downAngleV: 0,
  rotate: 140,
  rotateV: 10,
  branches: 1,
};

/** A small tree for lessons: a trunk, eight limbs and a handful of twigs on each. */
const FILE = {
  format: 'windgrove-species',
  version: 1,
  name: 'A small tree',
  tree: {
    shape: 4,
    baseSize: 0.3,
    scale: 6,
    scaleV: 0,
    zScale: 1,
    zScaleV: 0,
    levels: 3,
    ratio: 0.0115,
    ratioPower: 1.15,
    lobes: 0,
    lobeDepth: 0,
    flare: 0.4,
    attractionUp: 0.4,
  },
  levels: [
    { ...STEM, curveRes: 8, curve: 60, curveBack: -80, curveV: 40 },
    { ...STEM, length: 0.45, curve: -45, curveV: 30, downAngle: 58, downAngleV: -12, branches: 11 },
    { ...STEM, length: 0.42, curve: -30, curveV: 40, downAngle: 48, branches: 8 },
    { ...STEM, length: 0, branches: 0 },
  ],
  // They are not drawn; their weight makes the branches as slow as those of a tree in leaf.
  leaves: { count: 24, shape: 0, scale: 0.2, scaleX: 1, bend: 0.3, quality: 1 },
  wind: { stiffness: [1.6, 1, 1, 1], modulus: 3, density: 850, leafMass: 0.4 },
  bark: { colour: '#8f8474', dark: '#4a4238' },
  pruning: { ratio: 0, width: 0.5, widthPeak: 0.5, powerLow: 0.5, powerHigh: 0.5 },
};

export const SMALL_TREE_SEED = 4;

/** The species file of the small tree, for a link to the editor. */
export const smallTreeFile = (): string => JSON.stringify(FILE);

function parsed(): Species {
  const { species, faults } = parseSpecies(FILE);
  if (!species) throw new Error(faults.map((fault) => JSON.stringify(fault)).join('; '));
  return species;
}

let grown: GrownPacked | null = null;

/** The tree of the lessons, grown once a page: its pieces, packed as for the GPU. */
export function smallTree(): GrownPacked {
  grown ??= growPacked(parsed(), SMALL_TREE_SEED);
  return grown;
}
