/**
 * The part without pictures, for Node, workers and pages: files, growing, packing, wind, and writing trees for other programs.
 *
 * It knows no DOM, no three.js, no clock and no chance: the same arguments give the same bytes everywhere. Metres, seconds, radians; z is up.
 *
 * @example A tree from a file of your own, with every fault where there are any
 * ```ts
 * import { faultText, parseSpecies } from 'windgrove/core';
 *
 * const { species, faults } = parseSpecies('{ "format": "windgrove-species", "version": 1 }');
 * if (species) console.log(species.name);
 * else console.log(faults.map(faultText).join('\n'));
 * ```
 *
 * @example Growing: the same species and seed are the same tree on every machine
 * ```ts
 * import { growPacked, hashPacked, shipped } from 'windgrove/core';
 *
 * const species = await shipped.speciesOf('japanese-maple');
 * const { packed, stats } = growPacked(species, 3, { levels: 2 });
 * console.log(stats.height, packed.pieceCount, hashPacked(packed));
 * ```
 *
 * @example A tree as a file for other programs
 * ```ts
 * import { DEFAULT_EXPORT, exportTree, shipped } from 'windgrove/core';
 *
 * const species = await shipped.speciesOf('saguaro-cactus');
 * const wind = await shipped.windOf('breeze');
 * const [file] = await exportTree(species, 1, wind, { ...DEFAULT_EXPORT, format: 'glb', textures: 'none' });
 * console.log(file?.name, file?.bytes.length);
 * ```
 *
 * @example The force of a wind, and the pose of every branch in it
 * ```ts
 * import { createWindState, growPacked, poseTree, shipped, windForce, windStateAt, wizardWind } from 'windgrove/core';
 *
 * const wind = wizardWind({ beaufort: 5, steadiness: 0.3, turbulence: 0.4, stiffness: 1, direction: 0, seed: 1 });
 * const state = windStateAt({ ...wind, model: 'direct' }, 2.5, undefined, createWindState());
 * console.log(windForce(state, 0, 0, 10));
 *
 * const { packed } = growPacked(await shipped.speciesOf('quaking-aspen'), 1, { levels: 2 });
 * const pose = poseTree(packed, state, 'exact');
 * console.log(pose.length === packed.restPose.data.length);
 * ```
 *
 * @example A wind that comes around, for an animation that loops
 * ```ts
 * import { growPacked, LoopedPoses, shipped } from 'windgrove/core';
 *
 * const { packed } = growPacked(await shipped.speciesOf('quaking-aspen'), 1, { levels: 1 });
 * const loop = new LoopedPoses(packed, await shipped.windOf('fresh-breeze'), 0, 4);
 * console.log(loop.at(0).length, loop.seam < 0.01);
 * ```
 *
 * @module windgrove/core
 */

export { type Fault, faultText } from '../core/file/fault.ts';
export { parseForest } from '../core/forest/parse-forest.ts';
export { GrowthBudgetError } from '../core/grow/budget.ts';
export { NothingGrownError } from '../core/grow/nothing-grown.ts';
export type { TreeStats } from '../core/grow/stats.ts';
export { parseArbaro } from '../core/io/arbaro.ts';
export {
  DEFAULT_EXPORT,
  EXPORT_PARAMETERS,
  type ExportFile,
  type ExportFormat,
  type ExportOptions,
  readExportOptions,
} from '../core/io/export-options.ts';
export { exportTree } from '../core/io/export-tree.ts';
export { parseEzTree } from '../core/io/ez-tree.ts';
export { type GrownPacked, type GrowPackedOptions, growPacked } from '../core/pack/grow-packed.ts';
export { hashPacked } from '../core/pack/hash-packed.ts';
export { BRANCH_LAYERS, LEAF_LAYERS, PIECE_LAYERS, POSE_TARGETS, TEXEL } from '../core/pack/layout.ts';
export type { PackedTree, TexelArray } from '../core/pack/packed.ts';
export { blend } from '../core/species/blend.ts';
export { editSpecies, type SpeciesEdits } from '../core/species/edits.ts';
export { GROUPS, PARAMETERS } from '../core/species/parameters.ts';
export { type ParsedSpecies, parseSpecies } from '../core/species/parse.ts';
export { inSeason, ownSeasons, SEASONS, type Season } from '../core/species/season.ts';
export type { Species } from '../core/species/species.ts';
export { createWindState, type WindState, windStateAt } from '../core/wind/fade.ts';
export { windForce } from '../core/wind/force.ts';
export { loadWind } from '../core/wind/load-wind.ts';
export { LoopedPoses } from '../core/wind/looped-poses.ts';
export { type ParsedWind, parseWind } from '../core/wind/parse-wind.ts';
export { poseTree } from '../core/wind/pose-tree.ts';
export { SpringRun } from '../core/wind/spring-run.ts';
export { STILL, type Wind } from '../core/wind/wind.ts';
export { windText } from '../core/wind/wind-file.ts';
export { type WizardChoice, wizardWind } from '../core/wind/wizard.ts';
export { type ShippedSource, UnknownId } from '../element/shipped-source.ts';
export { shipped } from './shipped.ts';
