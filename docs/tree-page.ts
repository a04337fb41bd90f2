// What the pages of the pictures share: one tree on the stage, drawn at any time as its playing would.
import { parseSpecies } from '../src/core/species/parse.ts';
import type { Species } from '../src/core/species/species.ts';
import type { Wind } from '../src/core/wind/wind.ts';
import { Stage } from '../src/view/stage.ts';
import { uprightBox } from '../src/view/tree-extent.ts';
import { WindTree } from '../src/view/wind-tree.ts';
import { growInWorker } from '../src/worker/client.ts';

/** What the address asks for: species, seed, wind. */
export const asked = (name: string, otherwise: string): string =>
  new URLSearchParams(location.search).get(name) ?? otherwise;

export const textOf = async (file: string): Promise<string> => (await fetch(`/${file}`)).text();

export const speciesAsked = async (): Promise<Species> =>
  parseSpecies(await textOf(`species/${asked('species', 'quaking-aspen')}.json`)).species!;

/** The tree framed on a stage as large as the window; `show` draws it at a time, in seconds. */
export async function treeOnStage(
  species: Species,
  wind: Wind,
): Promise<{ stage: Stage; show: (time: number) => void }> {
  const stage = new Stage(document.querySelector<HTMLCanvasElement>('#stage')!, {
    shadows: 2048,
    preserveDrawingBuffer: true,
  });
  stage.resize(innerWidth, innerHeight);
  const { packed } = await growInWorker(species, Number(asked('seed', '1')));
  const tree = new WindTree();
  tree.setTree(packed, species);
  tree.setWind(wind);
  tree.setShadows(true, true);
  stage.scene.add(tree);
  stage.frame(uprightBox(packed.bounds));
  const show = (time: number): void => {
    do tree.update(stage.renderer, time);
    while (tree.catchingUp !== null);
    stage.blow(tree.windSource(), time);
    stage.render();
  };
  return { stage, show };
}
