// `npx tsx docs/make-forest-picture.ts`: docs/forest.webp, the forest of the README: a valley in autumn, with the sun low behind it.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseForest } from '../src/core/forest/parse-forest.ts';
import type { ForestJob } from './forest-picture.ts';
import { docs, save, webpOf, withPage } from './picture-browser.ts';

interface Pictures {
  readonly windgroveForestPicture: (job: ForestJob) => Promise<string>;
}

/** Bytes that the picture may have. */
const MOST = 200_000;

const { forest } = parseForest(readFileSync(join(docs, '../public/forests/broadleaf-valley.json'), 'utf8'));
if (!forest) throw new Error('The scene cannot be read.');
const job: ForestJob = {
  document: {
    ...forest,
    season: 'autumn',
    stage: 'golden',
    hour: null,
    camera: { x: 80, y: -130, z: 0, yaw: 140, pitch: 5.5 },
  },
  above: 5,
  width: 1600,
  height: 700,
  fine: 1,
  fov: 32,
  time: 12,
  variants: 4,
};

await withPage({ width: 400, height: 300 }, async (page, address) => {
  page.setDefaultTimeout(1_200_000);
  await page.goto(`${address}docs/forest-picture.html`);
  await page.waitForFunction(() => 'windgroveForestPicture' in window);
  const data = await page.evaluate((j) => (window as unknown as Pictures).windgroveForestPicture(j), job);
  const png = Buffer.from(data.split(',')[1]!, 'base64');
  for (let quality = 0.86; quality > 0.4; quality -= 0.06) {
    const picture = await webpOf(page, png, quality);
    if (picture.length < MOST) return save('forest.webp', picture);
  }
  throw new Error(`The picture does not fit into ${MOST} bytes.`);
});
