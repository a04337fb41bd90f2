// `npx tsx docs/make-species-strip.ts`: docs/species.webp, some of the portraits side by side.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { docs, save, webpOf, withPage } from './picture-browser.ts';

const SHOWN = [
  'cherry-spring',
  'silver-birch',
  'japanese-maple-autumn',
  'tamarack-autumn',
  'baobab',
  'queen-palm',
  'saguaro-cactus',
  'scots-pine',
  'swamp-white-oak',
  'bamboo',
];
const SIZE = { width: 200, height: 250 };
const ACROSS = 5;
const GAP = 4;

const rows = Math.ceil(SHOWN.length / ACROSS);
const size = {
  width: ACROSS * SIZE.width + (ACROSS - 1) * GAP,
  height: rows * SIZE.height + (rows - 1) * GAP,
};
await withPage(size, async (page) => {
  const pictures = SHOWN.map((name) => {
    const data = readFileSync(join(docs, `../public/species/portraits/${name}.webp`)).toString('base64');
    return `<img width="${SIZE.width}" height="${SIZE.height}" src="data:image/webp;base64,${data}">`;
  });
  await page.setContent(
    `<body style="margin:0;background:#fbfaf6;display:grid;gap:${GAP}px;grid-template-columns:repeat(${ACROSS},${SIZE.width}px)">${pictures.join('')}`,
  );
  await page.waitForFunction(() => [...document.images].every((image) => image.complete));
  save('species.webp', await webpOf(page, await page.screenshot(), 0.86));
});
