/**
 * Trees and forests in the wind for three.js.
 *
 * A tree is grown from a species and a seed, away from the page's own thread, and drawn by an `Object3D` that takes lights, shadows, fog and
 * environment maps as everything else does. Metres and seconds; y is up. `three` is a peer: there is one copy of it, yours.
 *
 * @example A tree in a scene
 * ```ts
 * import { DirectionalLight, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
 * import { growTree, inSeason, shipped, WindTree } from 'windgrove';
 *
 * const renderer = new WebGLRenderer();
 * const camera = new PerspectiveCamera(30, 1, 0.1, 500);
 * camera.position.set(0, 6, 30);
 * const species = await shipped.speciesOf('quaking-aspen');
 * const { packed } = await growTree(species, 7);
 * const tree = new WindTree();
 * tree.setTree(packed, inSeason(species, 'autumn'));
 * tree.setWind(await shipped.windOf('breeze'), { fade: 2 });
 * const scene = new Scene().add(tree, new DirectionalLight());
 * renderer.setAnimationLoop((milliseconds) => {
 *   tree.update(renderer, milliseconds / 1000);
 *   renderer.render(scene, camera);
 * });
 * ```
 *
 * @example A meadow for one tree: sky, sun, ground, grass and a camera to drag
 * ```ts
 * import { growTree, shipped, Stage, uprightBox, WindTree } from 'windgrove';
 *
 * const stage = new Stage(document.querySelector('canvas')!);
 * const species = await shipped.speciesOf('silver-birch');
 * const { packed } = await growTree(species, 1);
 * const tree = new WindTree();
 * tree.setTree(packed, species);
 * stage.scene.add(tree);
 * stage.resize(640, 480, devicePixelRatio);
 * stage.frame(uprightBox(packed.bounds));
 * tree.update(stage.renderer, 0);
 * stage.render();
 * ```
 *
 * @example A forest
 * ```ts
 * import { PerspectiveCamera, Scene, WebGLRenderer } from 'three';
 * import { Forest, forestField, parseForest, shipped } from 'windgrove';
 *
 * const { forest: document, faults } = parseForest(await (await fetch('forest.json')).text());
 * if (!document) throw new Error(faults.map(({ path, allowed }) => `${path}: ${allowed}`).join(' '));
 * const ids = document.mix.map(({ species }) => species);
 * const species = new Map(await Promise.all(ids.map(async (id) => [id, await shipped.speciesOf(id)] as const)));
 *
 * const forest = new Forest({ budget: 16 });
 * forest.setForest(document, species, forestField(document, null));
 * forest.setWind(await shipped.windOf(document.wind));
 *
 * const renderer = new WebGLRenderer();
 * const camera = new PerspectiveCamera(45, 1, 0.1, 2000);
 * const scene = new Scene().add(forest);
 * renderer.setAnimationLoop((now) => {
 *   camera.updateMatrixWorld();
 *   forest.update(renderer, camera, now / 1000, now);
 *   renderer.render(scene, camera);
 * });
 * ```
 *
 * @example What is wrong with a file of your own
 * ```ts
 * import { LoadError, loadSpecies } from 'windgrove';
 *
 * try {
 *   const species = await loadSpecies('my-tree.json');
 *   console.log(species.name);
 * } catch (error) {
 *   if (!(error instanceof LoadError)) throw error;
 *   for (const { path, found, allowed } of error.faults) console.log(`${path} is ${found}; allowed: ${allowed}`);
 * }
 * ```
 *
 * @module windgrove
 */

export type { Fault } from '../core/file/fault.ts';
export type { ForestDocument } from '../core/forest/forest.ts';
export { parseForest } from '../core/forest/parse-forest.ts';
export { forestField } from '../core/forest/terrain.ts';
export type { TreeStats } from '../core/grow/stats.ts';
export type { PackedTree } from '../core/pack/packed.ts';
export { inSeason, ownSeasons, SEASONS, type Season } from '../core/species/season.ts';
export type { Species } from '../core/species/species.ts';
export { STILL, type Wind } from '../core/wind/wind.ts';
export { type WizardChoice, wizardWind } from '../core/wind/wizard.ts';
export { type ShippedSource, UnknownId } from '../element/shipped-source.ts';
export { Clock } from '../view/clock.ts';
export { Forest, type ForestOptions, type ForestStats } from '../view/forest/forest.ts';
export { LoadError, type LoadOptions, loadSpecies, loadWind } from '../view/load.ts';
export { Stage, type StageOptions } from '../view/stage.ts';
export { uprightBox } from '../view/tree-extent.ts';
export { type Mode, WindTree, type WindTreeOptions } from '../view/wind-tree.ts';
export { GrowAborted, type GrownTree, type GrowProgress, isAborted } from '../worker/client.ts';
export { type GrowTreeOptions, growTree } from './grow-tree.ts';
export { shipped } from './shipped.ts';
