import { loadSpecies, loadWind } from '../view/load.ts';
import { Stage } from '../view/stage.ts';
import { uprightBox } from '../view/tree-extent.ts';
import { WindTree } from '../view/wind-tree.ts';
import { growInWorker } from '../worker/client.ts';
import { difference, pixelsOf, timeFrames } from './frame-timer.ts';
import { type Section, SIZE } from './section.ts';
import { words } from './words.ts';

/** Heights of the tree on screen, pixels. */
const HEIGHTS = [240, 120, 60, 30] as const;

/** One tree at range, as full geometry, by pixels, by the paper's rules. */
export const FAR: Section = {
  id: 'far',
  title: words.far.title,
  lead: words.far.lead,
  async run({ canvas, rounds, milliseconds, step }) {
    const stage = new Stage(canvas, { antialias: false, shadows: 0, preserveDrawingBuffer: true });
    try {
      stage.resize(...SIZE);
      const [species, wind] = await Promise.all([
        loadSpecies('species/quaking-aspen.json'),
        loadWind('winds/breeze.json'),
      ]);
      await step(words.growing(species.name));
      const { packed } = await growInWorker(species, 1);
      const ways = [
        { name: words.far.full, tree: new WindTree({ detail: 'high' }) },
        { name: words.far.screen, tree: new WindTree() },
        { name: words.far.paper, tree: new WindTree({ degradation: 'paper' }) },
      ];
      for (const { tree } of ways) {
        tree.setTree(packed, species);
        tree.setWind(wind);
        stage.scene.add(tree);
        await tree.degradationLoaded();
      }
      const box = uprightBox(packed.bounds);
      const show = (only: WindTree | null): void => {
        for (const { tree } of ways) tree.visible = tree === only;
      };
      const draw = (tree: WindTree | null, time: number): void => {
        show(tree);
        tree?.update(stage.renderer, time);
        stage.render();
      };
      // The ground hides where there is no tree: the tree alone is compared.
      for (const part of [stage.ground, stage.meadow]) part.visible = false;
      const rows: (string | number)[][] = [];
      for (const pixels of HEIGHTS) {
        await step(words.measuring(`${pixels} px`));
        const { position, target } = stage.frame(box);
        const away = (box.max.y * (stage.camera.projectionMatrix.elements[5] as number) * SIZE[1]) / 2 / pixels;
        stage.controls.maxDistance = 2 * away;
        stage.camera.position.copy(position).sub(target).setLength(away).add(target);
        stage.camera.far = 3 * away;
        stage.camera.updateProjectionMatrix();
        const frames = ways.map(({ name, tree }) => ({ name, draw: (n: number) => draw(tree, n / 30) }));
        const timings = timeFrames(stage.renderer, frames, rounds, milliseconds);
        const empty = pixelsOf(stage.renderer, () => draw(null, 3));
        const pictures = ways.map(({ tree }) => pixelsOf(stage.renderer, () => draw(tree, 3)));
        timings.forEach(({ name, triangles, median, ratio }, i) => {
          const apart = difference(pictures[0] as Uint8Array, pictures[i] as Uint8Array, empty);
          rows.push([name, pixels, triangles, median, ratio, apart]);
        });
      }
      return { table: { caption: words.far.caption, columns: words.far.columns, rows }, pictures: [] };
    } finally {
      stage.renderer.forceContextLoss();
      stage.dispose();
    }
  },
};
