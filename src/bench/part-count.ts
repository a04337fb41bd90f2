import { ForestScene } from './forest-scene.ts';
import { timeFrames } from './frame-timer.ts';
import type { Picture, Section } from './section.ts';
import { words } from './words.ts';

/** What a frame costs by the number of trees. */
export const COUNT: Section = {
  id: 'count',
  title: words.count.title,
  lead: words.count.lead,
  async run(bench) {
    const { canvas, rounds, milliseconds, step, counts } = bench;
    const scene = new ForestScene(canvas);
    try {
      const rows: (string | number)[][] = [];
      let picture: Picture | null = null;
      for (const count of counts) {
        const said = words.growing(`${count}`);
        await step(said);
        const from = performance.now();
        await scene.plant(count);
        const settled = await scene.settle(bench, said);
        const seconds = (performance.now() - from) / 1000;
        await step(words.measuring(`${count}`));
        const frame = { name: String(count), draw: (n: number) => scene.draw(2 + n / 30) };
        const [timing] = timeFrames(scene.stage.renderer, [frame], rounds, milliseconds);
        const { triangles, calls, median } = timing!;
        const { trees, near, middle, far, bytes } = scene.forest.stats();
        const asked = settled ? count : words.count.unsettled(String(count));
        rows.push([asked, trees, near, middle, far, triangles, calls, median, bytes / 1e6, seconds]);
        picture = { name: words.count.picture(count), url: canvas.toDataURL('image/webp', 0.86) };
      }
      const pictures = picture ? [picture] : [];
      return { table: { caption: words.count.caption, columns: words.count.columns, rows }, pictures };
    } finally {
      scene.dispose();
    }
  },
};
