import { ForestScene } from './forest-scene.ts';
import { difference, pixelsOf, timeFrames } from './frame-timer.ts';
import type { Picture, Section } from './section.ts';
import { words } from './words.ts';

/** Thresholds that put every tree into one class. */
const NEVER = 1e9;
const WAYS = [
  { name: words.classes.full, thresholds: { near: 0, middle: 0 } },
  { name: words.classes.cards, thresholds: { near: NEVER, middle: 0 } },
  { name: words.classes.impostors, thresholds: { near: NEVER, middle: NEVER } },
] as const;

/** The same trees in each class of the forest. */
export const CLASSES: Section = {
  id: 'classes',
  title: words.classes.title,
  lead: words.classes.lead,
  async run(bench) {
    const { canvas, rounds, milliseconds, step } = bench;
    const count = Math.max(4, Math.round(bench.trees / 4));
    const scene = new ForestScene(canvas);
    try {
      scene.forest.crossFade = 0;
      await step(words.growing(words.classes.caption(count)));
      await scene.plant(count);
      const { renderer } = scene.stage;
      scene.planted = false;
      const empty = pixelsOf(renderer, () => scene.draw(3));
      scene.planted = true;
      const found: { row: (string | number)[]; pixels: Uint8Array }[] = [];
      const pictures: Picture[] = [];
      for (const { name, thresholds } of WAYS) {
        scene.forest.thresholds = thresholds;
        await scene.settle(bench, words.growing(name));
        await step(words.measuring(name));
        const pixels = pixelsOf(renderer, () => scene.draw(3));
        pictures.push({ name, url: canvas.toDataURL('image/webp', 0.86) });
        const [timing] = timeFrames(renderer, [{ name, draw: (n) => scene.draw(3 + n / 30) }], rounds, milliseconds);
        const { triangles, calls, median } = timing!;
        const full = found[0];
        const ratio = full ? median / Number(full.row[3]) : 1;
        const apart = full ? difference(full.pixels, pixels, empty) : 0;
        found.push({ row: [name, triangles, calls, median, ratio, apart], pixels });
      }
      const rows = found.map(({ row }) => row);
      return { table: { caption: words.classes.caption(count), columns: words.classes.columns, rows }, pictures };
    } finally {
      scene.dispose();
    }
  },
};
