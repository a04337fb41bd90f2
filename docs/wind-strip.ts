// One tree in one of the winds that ship, for strips of frames: `show(t)` draws it at t seconds, as its playing would.
import type { Species } from '../src/core/species/species.ts';
import { loadWind } from '../src/core/wind/load-wind.ts';
import { Stage } from '../src/view/stage.ts';
import { uprightBox } from '../src/view/tree-extent.ts';
import { WindTree } from '../src/view/wind-tree.ts';
import { growInWorker } from '../src/worker/client.ts';

const asked = new URLSearchParams(location.search);
const text = async (file: string): Promise<string> => (await fetch(`/${file}`)).text();
const species = JSON.parse(await text(`species/${asked.get('species') ?? 'quaking-aspen'}.json`)) as Species;
const loaded = await loadWind(await text(`winds/${asked.get('wind') ?? 'breeze'}.json`), (csv) => text(`winds/${csv}`));
if (!loaded.wind) throw new Error(JSON.stringify(loaded.faults));

const stage = new Stage(document.querySelector<HTMLCanvasElement>('#stage')!, {
  shadows: 2048,
  preserveDrawingBuffer: true,
});
stage.resize(innerWidth, innerHeight);
const { packed } = await growInWorker(species, Number(asked.get('seed') ?? 1));
const tree = new WindTree();
tree.setTree(packed, species);
tree.setWind(loaded.wind);
tree.setShadows(true, true);
stage.scene.add(tree);
stage.frame(uprightBox(packed.bounds));

const show = (time: number): void => {
  do tree.update(stage.renderer, time);
  while (tree.catchingUp !== null);
  stage.render();
};
show(0); // compiles
Object.assign(window, { windgroveStrip: { show } });
