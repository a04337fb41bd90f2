import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { BARE, difference, open, picture, ready, settled, state, tips } from './editor-page.ts';

test.use({ viewport: { width: 800, height: 480 } });

type Json = Record<string, unknown>;
const aspen = (): Json & { tree: Json; levels: Json[]; leaves: Json } =>
  JSON.parse(readFileSync('public/species/quaking-aspen.json', 'utf8'));

const choose = (page: Page, text: string): Promise<void> =>
  page
    .locator('wg-grow input[type=file]')
    .setInputFiles({ name: 'mine.json', mimeType: 'application/json', buffer: Buffer.from(text) });

/** What is wrong with a file, and what the message must say of it: the path, and what was found or is allowed. */
const bad: readonly [what: string, text: () => string, says: readonly (string | RegExp)[]][] = [
  ['an empty file', () => '', ['empty']],
  ['broken JSON', () => '{"name": "x",', ['JSON']],
  ['something else', () => '[1, 2, 3]', ['object']],
  ['a wrong type', () => JSON.stringify({ ...aspen(), levels: 'many' }), ['levels', '"many"']],
  ['a missing key', () => JSON.stringify({ ...aspen(), tree: { ...aspen().tree, ratio: undefined } }), ['tree.ratio']],
  [
    'an unknown key',
    () => JSON.stringify({ ...aspen(), tree: { ...aspen().tree, ratoi: 1 } }),
    ['tree.ratoi', 'ratio'],
  ],
  ['NaN', () => JSON.stringify(aspen()).replace('"scale":13', '"scale":NaN'), ['JSON']],
  [
    'a negative count',
    () => JSON.stringify({ ...aspen(), tree: { ...aspen().tree, levels: -3 } }),
    ['tree.levels', '-3'],
  ],
  [
    'a huge number',
    () => JSON.stringify({ ...aspen(), tree: { ...aspen().tree, scale: 1e300 } }),
    ['tree.scale', /1e\+?300/],
  ],
];

test('a species file that is wrong or asks for too much says so and the tree stays; one of your own grows, travels in the link, and its name is text', async ({
  page,
  browser,
}) => {
  const complaints = await open(page, BARE);
  await settled(page);
  const before = { tips: await tips(page), state: await state(page) };
  const message = page.getByRole('alert');
  for (const [what, text, says] of bad) {
    await test.step(what, async () => {
      await choose(page, text());
      await expect(message).toContainText('mine.json was not opened');
      for (const words of says) await expect(message).toContainText(words);
      await page.getByRole('button', { name: 'Close this message' }).click();
      await expect(message).toHaveText('');
    });
  }
  expect(await state(page)).toEqual(before.state);
  expect(await tips(page)).toEqual(before.tips);

  const greedy = aspen();
  greedy.tree.levels = 4;
  for (const level of greedy.levels) level.branches = 1000;
  await choose(page, JSON.stringify(greedy));
  await expect(message).toContainText(/limit/);
  await ready(page);
  expect(await tips(page)).toEqual(before.tips);
  expect((await state(page)).ownSpecies).toBeNull();

  const name = '<img src=x onerror="window.hurt=1">Łąka';
  await choose(page, JSON.stringify({ ...aspen(), name, latin: '<b>x</b>' }));
  await expect(page.getByRole('heading', { level: 1 })).toHaveText(name);
  await ready(page);
  await expect(page).toHaveURL(/[#&](own|z)=/);
  const other = await browser.newPage();
  await other.goto(page.url());
  await ready(other);
  await expect(other.getByRole('heading', { level: 1 })).toHaveText(name);
  expect(await other.evaluate(() => 'hurt' in window)).toBe(false);
  expect(await page.locator('h1 img, i b').count()).toBe(0);
  await other.close();
  expect(complaints).toEqual([]);
});

test('nonsense in a link is named, each piece of it, and the rest of the link applies', async ({ page }) => {
  const complaints = await open(
    page,
    's=oak<b>&seed=-1&t=1e99&cam=1,2&w2=0.1,0,5,NaN,2,0&levels=2&leaves=0&paused=1&tiger=1',
  );
  const message = page.getByRole('alert');
  for (const words of ['oak<b>', 'seed', '-1', '1e99', 'cam', '1,2', 'w2 speed', 'NaN', 'tiger']) {
    await expect(message).toContainText(words);
  }
  const { wind, ...now } = await state(page);
  expect(now).toMatchObject({
    species: 'quaking-aspen',
    time: 0,
    camera: null,
    levelsShown: 2,
    showLeaves: false,
    paused: true,
  });
  expect(wind.waves[1]).toMatchObject({ amplitude: 0.1, direction: 0, wavelength: 5, sharpness: 2 });
  expect(complaints).toEqual([]);
});

test('without WebGL2 there is a still picture and a message', async ({ page }) => {
  await page.addInitScript(() => {
    const real = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind.startsWith('webgl') ? null : Reflect.apply(real, this, [kind, ...rest]);
    } as typeof real;
  });
  await page.goto(`./#${BARE}`);
  await ready(page);
  await expect(page.getByRole('alert')).toContainText('This is a still picture');
  await expect(page.getByRole('alert')).toContainText('WebGL2');
  await settled(page);
  const before = await picture(page);
  await page.evaluate(() => window.windgrove!.seek(3));
  await settled(page);
  const { pixels, colours } = await difference(page, before, await picture(page));
  expect(colours).toBeGreaterThan(20);
  expect(pixels.length).toBeGreaterThan(0);
});

test('who wants less motion finds time standing still, and is told so', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, 'levels=1&leaves=0');
  await settled(page);
  expect(await state(page)).toMatchObject({ paused: true, time: 0 });
  await expect(page.getByText('Your system asks for less motion')).toBeVisible();
  await page.getByRole('button', { name: 'Play' }).click();
  await expect.poll(() => page.evaluate(() => window.windgrove!.time())).toBeGreaterThan(0);
});

test('a first visit sees the aspen move, once it has seen that there are others', async ({ page }) => {
  await open(page, '');
  await page.keyboard.press('Escape');
  expect(await state(page)).toMatchObject({ species: 'quaking-aspen', paused: false, blowing: true });
  await expect.poll(() => page.evaluate(() => window.windgrove!.time())).toBeGreaterThan(0);
});
