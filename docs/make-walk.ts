// `npx tsx docs/make-walk.ts [NAME...]`: the pictures of docs/walk.md, a newcomer's first five minutes, taken from the editor as a person uses it.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from '@playwright/test';
import type { TestHook } from '../src/editor/test-hook.ts';
import { docs, save, webpOf, withPage } from './picture-browser.ts';

const WIDE = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844 };
/** The tree stands still in the pictures, at a moment at which it leans. */
const MOMENT = 't=4.5&paused=1';
/** Limbs alone, from near: each can be taken hold of. */
const LIMBS = 'seed=3&t=2&paused=1&tree.levels=2&leaves=0&cam=11,3,20,0,8,0';

const ready = (page: Page) => page.waitForSelector('html[data-ready="true"]', { timeout: 120_000 });
const settled = (page: Page) => page.evaluate(() => (window as unknown as { windgrove: TestHook }).windgrove.settled());

/** Selects the limb whose middle stands freest in the picture. */
async function selectLimb(page: Page): Promise<void> {
  const { branches, stems } = await page.evaluate(() =>
    (window as unknown as { windgrove: TestHook }).windgrove.onScreen(),
  );
  const middles = stems.flatMap((stem, piece) => {
    const [x, y] = [branches[2 * (9 * piece + 5)]!, branches[2 * (9 * piece + 5) + 1]!];
    return stem === 0 || x < 480 || x > 860 || y < 120 || y > 560 ? [] : [{ x, y }];
  });
  const alone = (a: { x: number; y: number }): number =>
    Math.min(...middles.map((b) => (a === b ? 1e9 : Math.hypot(a.x - b.x, a.y - b.y))), Math.abs(a.x - 640) / 2);
  const best = middles.reduce((a, b) => (alone(b) > alone(a) ? b : a));
  await page.mouse.click(best.x, best.y);
  await page.waitForSelector('wg-stem .stem-card, wg-stem section, wg-stem aside');
}

interface Scene {
  readonly link: string;
  readonly act: (page: Page) => Promise<unknown>;
  readonly phone?: true;
}

/** Waits until every picture in sight is there. */
const pictured = (page: Page) =>
  page.waitForFunction(() =>
    [...document.querySelectorAll<HTMLImageElement>('dialog[open] img')]
      .filter((img) => img.checkVisibility() && img.getBoundingClientRect().top < innerHeight)
      .every((img) => img.complete),
  );

const scenes: Readonly<Record<string, Scene>> = {
  gallery: { link: 'gallery', act: pictured },
  species: { link: 'gallery=sugar-maple', act: pictured },
  first: { link: MOMENT, act: async () => undefined },
  tour: {
    link: MOMENT,
    act: async (page) => {
      await page.getByRole('button', { name: 'Show me around' }).click();
      await page.getByRole('button', { name: 'Next' }).click();
      // The light glides from stop to stop; the words come when it stands.
      await page.getByText('2 of ').waitFor();
    },
  },
  parameter: {
    link: MOMENT,
    act: async (page) => {
      await page.getByRole('searchbox').fill('down angle');
      const box = page.locator('#p-levels-1-downAngle-number');
      await box.fill('95');
      await box.press('Enter');
      await ready(page);
      await page.getByRole('button', { name: /^Limbs: Down angle/ }).click();
      await page.locator('.low-high img').first().waitFor();
    },
  },
  limb: { link: LIMBS, act: selectLimb },
  curves: {
    link: `${MOMENT}&pruning.ratio=1&pruning.width=0.2`,
    act: async (page) => {
      await page.locator('.tree-fold[data-section="pruning"] > summary').click();
      await page.locator('svg.curve').last().scrollIntoViewIfNeeded();
    },
  },
  variety: {
    link: MOMENT,
    act: async (page) => {
      await page.getByRole('button', { name: /^(More like this|Other trees)/ }).click();
      await page.waitForFunction(
        () => document.querySelectorAll('.card image[href], .card img[src]').length >= 12,
        null,
        { timeout: 240_000 },
      );
    },
  },
  history: {
    link: MOMENT,
    act: async (page) => {
      await page.getByRole('searchbox').fill('length');
      for (const [id, value] of [
        ['#p-levels-1-length-number', '0.45'],
        ['#p-levels-2-length-number', '0.4'],
      ] as const) {
        await page.locator(id).fill(value);
        await page.locator(id).press('Enter');
        await ready(page);
      }
      await page.getByRole('searchbox').fill('');
      await page.getByRole('button', { name: /^Undo/ }).first().click();
      await ready(page);
      await page.getByRole('button', { name: /^History/ }).click();
      await page.getByRole('button', { name: 'Keep this as a snapshot' }).click();
      await page.locator('.snapshot img').waitFor();
    },
  },
  export: {
    link: MOMENT,
    act: async (page) => {
      await page.getByRole('button', { name: /^Export/ }).click();
      await page.getByText(/\d triangles/).waitFor();
    },
  },
  palette: {
    link: MOMENT,
    act: async (page) => {
      await page.keyboard.press('Control+k');
      await page.getByRole('combobox', { name: 'Find a command' }).fill('curve limbs');
    },
  },
  photo: {
    link: `${MOMENT}&s=silver-birch&stage=golden`,
    act: async (page) => {
      await page.keyboard.press('v');
      await page.getByRole('button', { name: 'Take the picture' }).waitFor();
    },
  },
  phone: { link: MOMENT, act: async () => undefined, phone: true },
};

async function taken(browser: Browser, address: string, name: string, { link, act, phone }: Scene): Promise<void> {
  const page = await browser.newPage({ viewport: phone ? PHONE : WIDE, hasTouch: !!phone, colorScheme: 'light' });
  await page.goto(`${address}#${link}`);
  await ready(page);
  await page.waitForSelector(phone ? 'wg-grow' : 'wg-time', { state: 'attached' });
  await act(page);
  await settled(page);
  save(`walk/${name}.webp`, await webpOf(page, await page.screenshot(), 0.8));
  await page.close();
}

const asked = process.argv.slice(2);
mkdirSync(join(docs, 'walk'), { recursive: true });
await withPage(WIDE, async (_, address, browser) => {
  for (const [name, scene] of Object.entries(scenes)) {
    if (asked.length > 0 && !asked.includes(name)) continue;
    await taken(browser, address, name, scene);
  }
});
