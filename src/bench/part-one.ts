import { loadSpecies, loadWind } from '../view/load.ts';
import { Stage } from '../view/stage.ts';
import { uprightBox } from '../view/tree-extent.ts';
import { WindTree } from '../view/wind-tree.ts';
import { growInWorker } from '../worker/client.ts';
import { ezTree } from './ez.ts';
import { timeFrames } from './frame-timer.ts';
import { type Picture, type Section, SIZE } from './section.ts';
import { words } from './words.ts';

const PRESET = 'Aspen Medium';

/** One tree of ours beside one of ez-tree's. */
export const ONE: Section = {
  id: 'one',
  title: words.one.title,
  lead: words.one.lead,
  async run({ canvas, rounds, milliseconds, step }) {
    const stage = new Stage(canvas, { antialias: false, preserveDrawingBuffer: true });
    try {
      stage.resize(...SIZE);
      const [species, wind] = await Promise.all([
        loadSpecies('species/quaking-aspen.json'),
        loadWind('winds/breeze.json'),
      ]);
      await step(words.growing(species.name));
      const began = performance.now();
      const { packed } = await growInWorker(species, 2);
      const tree = new WindTree();
      tree.setTree(packed, species);
      tree.setWind(wind);
      tree.setShadows(true, true);
      stage.scene.add(tree);
      const box = uprightBox(packed.bounds);
      stage.frame(box);
      const shot = (name: string): Picture => ({ name, url: canvas.toDataURL('image/webp', 0.86) });
      tree.update(stage.renderer, 2);
      stage.render();
      stage.renderer.getContext().finish();
      const first = (performance.now() - began) / 1000;
      const ours = shot(`Windgrove, ${species.name}`);
      tree.visible = false;
      await step(words.growing(PRESET));
      const from = performance.now();
      const other = await ezTree(PRESET, box.max.y);
      stage.scene.add(other.object);
      other.update(2);
      stage.render();
      stage.renderer.getContext().finish();
      const second = (performance.now() - from) / 1000;
      const theirs = shot(other.name);
      await step(words.measuring(words.one.title));
      const show = (mine: boolean): void => {
        tree.visible = mine;
        other.object.visible = !mine;
      };
      const frames = [
        {
          name: other.name,
          draw: (n: number) => {
            show(false);
            other.update(n / 30);
            stage.render();
          },
        },
        {
          name: ours.name,
          draw: (n: number) => {
            show(true);
            tree.update(stage.renderer, n / 30);
            stage.render();
          },
        },
      ];
      const timings = timeFrames(stage.renderer, frames, rounds, milliseconds);
      const more = [
        [other.bytes, second],
        [tree.stats().bytes, first],
      ] as const;
      const rows = timings.map(({ name, triangles, median, ratio }, i) => {
        const [bytes, seconds] = more[i] as readonly [number, number];
        return [name, triangles, median, ratio, bytes / 1e6, seconds];
      });
      return { table: { caption: words.one.caption, columns: words.one.columns, rows }, pictures: [theirs, ours] };
    } finally {
      stage.renderer.forceContextLoss();
      stage.dispose();
    }
  },
};
