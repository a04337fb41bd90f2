import { parametersOf } from '../../../core/grow/plan.ts';
import { PLACES } from '../../../core/species/edits.ts';
import { withReadings } from '../../../core/species/readings.ts';
import type { LevelParameters, Species } from '../../../core/species/species.ts';
import type { Wind } from '../../../core/wind/wind.ts';
import { ofBark, ofFoliage, ofOrgan, ofSeason, type WhyLook } from './no-effect-look.ts';

/** Why a parameter does nothing at present; the words are in words/tree.ts. */
export type Why =
  | WhyLook
  | 'noLevel'
  | 'noStems'
  | 'noLimbs'
  | 'noDeep'
  | 'crownDrawn'
  | 'noLobes'
  | 'noLobeDepth'
  | 'noBulges'
  | 'noBulgeDepth'
  | 'oneTrunk'
  | 'oneSegment'
  | 'noSplits'
  | 'helix'
  | 'noHelix'
  | 'fan'
  | 'noLeaves'
  | 'noTwigs'
  | 'ownOutline'
  | 'noPruning'
  | 'asPrinted'
  | 'noAttraction'
  | 'noFlutter'
  | 'springsOnly';

const LEAF_ANGLES: readonly string[] = ['downAngle', 'downAngleV', 'rotate', 'rotateV'];
const OF_SPLITS: readonly string[] = ['splitAngle', 'splitAngleV'];
const OF_SEGMENTS: readonly string[] = ['segSplits', 'baseSplits', 'curve', 'curveBack', 'curveSideV', ...OF_SPLITS];
const OF_SPRINGS: readonly string[] = ['modulus', 'density', 'leafMass', 'damping'];

/** Whether stems of this level grow at all. */
function grows(species: Species, level: number): boolean {
  if (level >= species.tree.levels) return false;
  for (let n = 1; n <= level; n++) if (parametersOf(species, n).branches === 0) return false;
  return true;
}

const hasTwigs = (species: Species): boolean => grows(species, species.tree.levels - 1);
const hasLeaves = (species: Species): boolean => species.leaves.count !== 0 && hasTwigs(species);

const splits = (species: Species, level: number): boolean => {
  const p = parametersOf(species, level);
  return p.curveRes > 1 && (p.segSplits > 0 || (level === 0 && p.baseSplits > 0));
};

/** Whether the leaves take this angle of this level, not having their own (weber-penn.md, row 42). */
const leavesTake = (species: Species, level: number, key: string): boolean =>
  level === Math.min(species.tree.levels, 3) &&
  hasLeaves(species) &&
  LEAF_ANGLES.includes(key) &&
  species.leaves[key as 'downAngle'] === undefined;

/** Why a parameter of a species changes nothing as things are; undefined where it does, or where that is not known. */
export function noEffect(path: string, given: Species, model?: Wind['model']): Why | undefined {
  const place = PLACES.get(path);
  if (!place) return undefined;
  const { parameter, level } = place;
  const species = withReadings(given);
  if (level !== undefined) return ofLevel(species, level, parameter.key);
  switch (parameter.group) {
    case 'tree':
      return ofTree(species, parameter.key);
    case 'leaves':
      return ofLeaves(species, parameter.key);
    case 'pruning':
      return ofPruning(species, parameter.key);
    case 'switches':
      return ofSwitches(species, given.switches.paper, parameter.key);
    case 'bark':
      return ofBark(species, parameter.key);
    case 'foliage':
      return hasLeaves(species) ? ofFoliage(species, parameter.key) : 'noLeaves';
    case 'organ':
      return hasLeaves(species) ? ofOrgan(species, parameter.key) : 'noLeaves';
    case 'spring':
    case 'autumn':
    case 'winter':
      return hasLeaves(species) ? ofSeason(species, parameter.group, parameter.key) : 'noLeaves';
    case 'wind':
      return ofWind(species, parameter.key, model);
    default:
      return undefined;
  }
}

function ofLevel(species: Species, level: number, key: string): Why | undefined {
  if (leavesTake(species, level, key)) return undefined;
  if (level >= species.tree.levels) return 'noLevel';
  // The number of stems is what brings them back.
  if (!grows(species, key === 'branches' ? level - 1 : level)) return 'noStems';
  const p: LevelParameters = parametersOf(species, level);
  if (p.curveRes <= 1 && OF_SEGMENTS.includes(key)) return 'oneSegment';
  if (OF_SPLITS.includes(key) && !splits(species, level)) return 'noSplits';
  if (p.curveV < 0 && (key === 'curve' || key === 'curveBack')) return 'helix';
  if (p.curveV >= 0 && key === 'helixTurns') return 'noHelix';
  if (level > 0 && p.branches < 0 && key === 'rotateV') return 'fan';
  if (key === 'lobes' && p.lobeDepth === 0) return 'noLobeDepth';
  if (key === 'lobeDepth' && p.lobes === 0) return 'noLobes';
  return undefined;
}

function ofTree(species: Species, key: string): Why | undefined {
  const { tree } = species;
  const limbs = grows(species, 1);
  switch (key) {
    case 'shape':
      return limbs ? (tree.crown ? 'crownDrawn' : undefined) : 'noLimbs';
    case 'crown':
    case 'ratioPower':
      return limbs ? undefined : 'noLimbs';
    case 'attractionUp':
      return grows(species, 2) ? undefined : 'noDeep';
    case 'lobes':
      return tree.lobeDepth === 0 ? 'noLobeDepth' : undefined;
    case 'lobeDepth':
      return tree.lobes === 0 ? 'noLobes' : undefined;
    case 'bulges':
      return tree.bulgeDepth === 0 ? 'noBulgeDepth' : undefined;
    case 'bulgeDepth':
      return tree.bulges === 0 ? 'noBulges' : undefined;
    case 'disc':
      return Math.abs(parametersOf(species, 0).branches) <= 1 ? 'oneTrunk' : undefined;
    default:
      return undefined;
  }
}

function ofLeaves(species: Species, key: string): Why | undefined {
  if (!hasTwigs(species)) return 'noTwigs';
  if (key === 'count') return undefined;
  if (!hasLeaves(species)) return 'noLeaves';
  if (key === 'rotateV' && species.leaves.count < 0) return 'fan';
  if (key !== 'shape') return undefined;
  if (species.foliage.margin) return 'ownMargin';
  return species.foliage.outline === undefined ? undefined : 'ownOutline';
}

function ofPruning(species: Species, key: string): Why | undefined {
  if (!grows(species, 1)) return 'noLimbs';
  const { tree, pruning } = species;
  // Shape 8 takes the lengths of the main branches from the envelope, pruned or not.
  const shapes = tree.shape === 8 && !tree.crown && key !== 'width';
  return key === 'ratio' || pruning.ratio > 0 || shapes ? undefined : 'noPruning';
}

function ofSwitches(species: Species, paper: boolean, key: string): Why | undefined {
  if (paper && (key === 'branchesAboveBase' || key === 'halveCloning' || key === 'paperAttraction')) return 'asPrinted';
  switch (key) {
    case 'branchesAboveBase':
      return grows(species, 1) ? undefined : 'noLimbs';
    case 'halveCloning':
    case 'spread': {
      const levels = Array.from({ length: species.tree.levels }, (_, n) => n);
      return levels.some((n) => grows(species, n) && splits(species, n)) ? undefined : 'noSplits';
    }
    case 'paperAttraction':
      return species.tree.attractionUp !== 0 && grows(species, 2) ? undefined : 'noAttraction';
    case 'pruneBase':
      return species.pruning.ratio > 0 ? undefined : 'noPruning';
    default:
      return undefined;
  }
}

function ofWind(species: Species, key: string, model: Wind['model'] | undefined): Why | undefined {
  if (['flutter', 'flutterRate', 'leafMass'].includes(key) && !hasLeaves(species)) return 'noLeaves';
  if (key === 'flutterRate' && species.wind.flutter === 0) return 'noFlutter';
  return model !== undefined && model !== 'spring' && OF_SPRINGS.includes(key) ? 'springsOnly' : undefined;
}
