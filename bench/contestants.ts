import { Box3, type Object3D, type WebGLRenderer } from 'three';
import { shippedWind } from '../e2e/pages/shipped-wind.ts';
import { loadPreset } from '../src/bench/ez.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import { inSeason, type Season } from '../src/core/species/season.ts';
import { uprightBox } from '../src/view/tree-extent.ts';
import { WindTree } from '../src/view/wind-tree.ts';
import { growInWorker } from '../src/worker/client.ts';

/** A tree to draw beside another. */
export interface Contestant {
  readonly name: string;
  readonly object: Object3D;
  /** Moves it to a time in seconds, as its own program does for each frame. */
  readonly update: (time: number) => void;
  /** Box at rest, metres, y up. */
  readonly box: Box3;
  /** Leaves that the last frame drew. */
  readonly leaves: () => number;
}

/** ez-tree's preset at a height in metres. A leaf is two crossed quads; its wind moves leaves only, branches stand still. */
export async function ezTree(preset: string, height: number): Promise<Contestant> {
  const tree = await loadPreset(preset);
  const own = new Box3().setFromObject(tree);
  tree.scale.setScalar(height / own.max.y);
  tree.updateMatrixWorld(true);
  return {
    name: `ez-tree 1.1.0, ${preset}`,
    object: tree,
    update: (time) => tree.update(time),
    box: new Box3().setFromObject(tree),
    leaves: () => tree.leavesMesh.geometry.index!.count / 12,
  };
}

/** A shipped species of ours, grown in the worker, in its default wind. */
export async function windgroveTree(
  name: string,
  seed: number,
  renderer: WebGLRenderer,
  { leafBudget, season = 'summer' }: { readonly leafBudget?: number; readonly season?: Season } = {},
): Promise<Contestant> {
  const species = parseSpecies(await (await fetch(`/species/${name}.json`)).text()).species!;
  const { packed } = await growInWorker(species, seed);
  const tree = new WindTree(leafBudget === undefined ? {} : { leafBudget });
  tree.setTree(packed, inSeason(species, season));
  tree.setWind(await shippedWind('breeze'));
  tree.setShadows(true, true);
  return {
    name: `Windgrove, ${species.name}${leafBudget === undefined ? '' : `, leafBudget ${leafBudget}`}`,
    object: tree,
    update: (time) => tree.update(renderer, time),
    box: uprightBox(packed.bounds),
    leaves: () => tree.stats().leaves,
  };
}
