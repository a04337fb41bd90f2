// `npx tsx docs/make-cards.ts [site] [forest] [learn]`: public/cards/*.jpg, the pictures that links to the site unfold into (src/site/cards.ts), from our own renders.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { CARD_HEIGHT, CARD_WIDTH, CARDS } from '../src/site/cards.ts';
import { withPage } from './picture-browser.ts';
import type { SpeciesJob } from './species-picture.ts';

interface Pictures {
  readonly windgroveSpecies: (job: SpeciesJob) => Promise<string>;
}

/** Pixels of a picture whose middle is where the card has room beside its words; what is beyond the card is cut off. */
const WIDE = 1720;

/** Bytes that a card may have: programs that unfold links give up on larger ones. */
const MOST = 150_000;

const root = join(import.meta.dirname, '..');
const dataOf = (png: Buffer): string => `data:image/png;base64,${png.toString('base64')}`;

/** A tree in the middle of a wide picture, bare or in leaf. */
async function tree(page: Page, address: string, job: Partial<SpeciesJob> & { readonly id: string }): Promise<string> {
  await page.goto(`${address}docs/species-picture.html`);
  await page.waitForFunction(() => 'windgroveSpecies' in window, null, { timeout: 120_000 });
  const { id, ...rest } = job;
  const text = readFileSync(join(root, `public/species/${id}.json`), 'utf8');
  const whole: SpeciesJob = {
    text,
    seed: 1,
    season: 'summer',
    stage: 'golden',
    hour: null,
    view: 'close',
    leaves: true,
    width: WIDE,
    height: CARD_HEIGHT,
    fine: 1.5,
    png: true,
    ...rest,
  };
  return page.evaluate((j) => (window as unknown as Pictures).windgroveSpecies(j), whole);
}

/** The forest's page without its panels. */
async function forest(page: Page, address: string): Promise<string> {
  await page.goto(`${address}forest.html#trees=500`);
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true', null, { timeout: 300_000 });
  await page.waitForFunction(
    () => (window as unknown as { windgroveForest: { settled(): boolean } }).windgroveForest.settled(),
    null,
    { timeout: 300_000 },
  );
  await page.addStyleTag({ content: '#interface { display: none }' });
  return dataOf(await page.screenshot());
}

/** A picture with words on it, as JPEG: what every program that unfolds links can show. */
async function card(page: Page, picture: string, title: string, about: string): Promise<Buffer> {
  const veil = '251, 250, 246';
  await page.setContent(
    `<body style="margin:0;width:${CARD_WIDTH}px;height:${CARD_HEIGHT}px;overflow:hidden;position:relative;color:#1d2021;font-family:system-ui,sans-serif">
    <img alt="" src="${picture}" style="position:absolute;left:0;top:0;height:100%">
    <div style="position:absolute;inset:0;background:linear-gradient(to right, rgba(${veil}, .9) 0, rgba(${veil}, .7) 34%, rgba(${veil}, 0) 62%)"></div>
    <div style="position:absolute;left:72px;top:0;bottom:0;width:430px;display:flex;flex-direction:column;justify-content:center">
      <div style="font:500 76px/1.05 ui-serif,'Iowan Old Style',Palatino,Georgia,'Noto Serif',serif;letter-spacing:-0.01em">${title}</div>
      <div style="margin-top:24px;font-size:30px;line-height:1.35">${about}</div></div></body>`,
    { waitUntil: 'load' },
  );
  for (let quality = 88; quality > 40; quality -= 6) {
    const jpeg = await page.screenshot({ type: 'jpeg', quality });
    if (jpeg.length <= MOST) return jpeg;
  }
  throw new Error('The picture does not fit into the bytes of a card.');
}

const makers: Readonly<Record<keyof typeof CARDS, (page: Page, address: string) => Promise<Buffer>>> = {
  site: async (page, address) =>
    card(
      page,
      await tree(page, address, { id: 'california-black-oak' }),
      'Windgrove',
      'Trees grown in the browser, with wind through every branch of them',
    ),
  forest: async (page, address) =>
    card(page, await forest(page, address), 'Forest', 'Fly through a hillside whose every branch the wind moves'),
  learn: async (page, address) =>
    card(
      page,
      await tree(page, address, { id: 'california-black-oak', season: 'winter', stage: 'studio', leaves: false }),
      'Lessons',
      'Growing trees and bending them in the wind: the papers as living pages',
    ),
};

const asked = process.argv.slice(2);
mkdirSync(join(root, 'public/cards'), { recursive: true });
await withPage({ width: CARD_WIDTH, height: CARD_HEIGHT }, async (_, address, browser) => {
  for (const [name, make] of Object.entries(makers)) {
    if (asked.length > 0 && !asked.includes(name)) continue;
    // A page for each: the forest keeps its own busy for longer than it is needed.
    const page = await browser.newPage({ viewport: { width: CARD_WIDTH, height: CARD_HEIGHT }, deviceScaleFactor: 1 });
    page.setDefaultTimeout(300_000);
    const jpeg = await make(page, address);
    await page.close();
    writeFileSync(join(root, 'public', CARDS[name as keyof typeof CARDS].file), jpeg);
    console.log(`${name}: ${Math.round(jpeg.length / 1000)} kB`);
  }
});
