import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';
import { BARE, open, state } from './editor-page.ts';

// Small, so that portraits are drawn fast.
test.use({ viewport: { width: 620, height: 480 } });

const card = (page: Page, name: RegExp) => page.getByRole('list', { name: 'Species' }).getByRole('link', { name });

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** What axe finds wrong with the gallery, all species and the page of one, as rule: first place. */
async function faults(page: Page): Promise<string[]> {
  await page.addScriptTag({ path: axe });
  return page.evaluate(async () => {
    const { axe } = window as unknown as {
      axe: { run(part: string): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    const all = document.querySelector<HTMLElement>('.gallery-all')!;
    const { violations } = await axe.run('dialog');
    all.hidden = false;
    const more = (await axe.run('.gallery-all')).violations;
    all.hidden = true;
    return [...violations, ...more].map((v) => `${v.id}: ${v.nodes[0]?.html}`);
  });
}

test('a newcomer sees all species, finds one, reads its page and grows it, by keyboard alone; back turns the pages', async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('./');
  await expect(page.getByRole('dialog', { name: 'Choose a tree' })).toBeVisible();
  await expect(card(page, /Quaking Aspen/)).toBeFocused();
  await expect(page).toHaveURL(/#gallery$/);

  await page.getByRole('searchbox', { name: 'Find a species' }).focus();
  await page.keyboard.type('no such tree');
  await expect(page.getByText('No species is called so')).toBeVisible();
  await page.getByRole('button', { name: 'Show all species' }).click();
  // The button that was pressed is gone; the focus is not.
  await expect(page.getByRole('searchbox', { name: 'Find a species' })).toBeFocused();
  await page.getByRole('combobox', { name: 'Kind' }).selectOption('Broadleaf');
  await page.getByRole('combobox', { name: 'Season' }).selectOption('Autumn');
  await expect(card(page, /Black Tupelo/).locator('img')).toHaveAttribute('src', /black-tupelo-autumn\.webp$/);
  await page.getByRole('searchbox', { name: 'Find a species' }).fill('carnegiea');
  await page.getByRole('combobox', { name: 'Kind' }).selectOption('All');
  await page.getByRole('searchbox', { name: 'Find a species' }).press('ArrowDown');
  await expect(card(page, /Saguaro/)).toBeFocused();
  await page.keyboard.press('Enter');

  await expect(page).toHaveURL(/#gallery=saguaro-cactus$/);
  await expect(page.getByRole('heading', { name: 'Saguaro', level: 3 })).toBeVisible();
  await expect(page.getByRole('link', { name: 'Download the file' })).toHaveAttribute(
    'download',
    'saguaro-cactus.json',
  );
  expect(await faults(page)).toEqual([]);

  await page.goBack();
  await expect(card(page, /Saguaro/)).toBeFocused();
  await page.goForward();
  await expect(page.getByRole('button', { name: 'Edit this tree' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('dialog')).toBeHidden();
  await expect(page.locator('.picture canvas')).toBeFocused();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Saguaro');
  expect(await state(page)).toMatchObject({ species: 'saguaro-cactus', season: 'summer' });
  await expect(page).toHaveURL(/#s=saguaro-cactus/);
});

test('a link to the page of a species opens it without a complaint, and its portrait moves in each season', async ({
  page,
}) => {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.goto('./#gallery=dog-rose');
  await expect(page.getByRole('heading', { name: 'Dog Rose', level: 3 })).toBeVisible();
  const canvas = page.locator('wg-species canvas[data-live]');
  await expect(canvas).toBeVisible({ timeout: 60_000 });
  await page.getByRole('button', { name: 'Dog Rose in winter' }).click();
  await expect(canvas).toHaveCount(0);
  await expect(canvas).toBeVisible({ timeout: 60_000 });
  expect(complaints).toEqual([]);
});

test('a portrait moves under the pointer, and the tree behind waits; closing leaves all as it was', async ({
  page,
}) => {
  await open(page, BARE);
  // The address is written a little after the picture.
  await expect(page).toHaveURL(/#s=quaking-aspen&seed=3/);
  const before = page.url();
  await page.keyboard.press('p');
  const cactus = card(page, /Saguaro/);
  await cactus.hover();
  const canvas = cactus.locator('canvas[data-live]');
  await expect(canvas).toBeVisible({ timeout: 60_000 });
  const pixels = (): Promise<string> => canvas.evaluate((each: HTMLCanvasElement) => each.toDataURL());
  const first = await pixels();
  await expect.poll(pixels).not.toBe(first);
  await page.getByRole('button', { name: 'Close' }).hover();
  await expect(canvas).toHaveCount(0);
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toBeHidden();
  await expect(page).toHaveURL(before);
  expect(await state(page)).toMatchObject({ species: 'quaking-aspen', seed: 3, paused: true, time: 2 });
});
