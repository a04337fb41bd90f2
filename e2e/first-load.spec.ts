import { gzipSync } from 'node:zlib';
import { expect, type Response, test } from '@playwright/test';
import { ready } from './editor-page.ts';

/** Bytes of JavaScript, gzipped, that may travel before the first tree moves. */
const BUDGET = 350_000;

/** What is loaded when it is asked for, and a piece of its code that nothing else has. */
const LATER: readonly (readonly [string, RegExp])[] = [
  ['the export dialog', /define\(.wg-export\W/],
  ['the palette', /define\(.wg-palette\W/],
  ['the history', /define\(.wg-history\W/],
  ['the varieties', /define\(.wg-variety\W/],
  ['the help', /define\(.wg-help\W/],
  ['the panels at the sides', /define\(.wg-wind\W/],
  ['the settings of the tree', /define\(.wg-tree\W/],
  ['the panels of the studio', /define\(.wg-studio-plots\W/],
  ['the plots', /u-axis/],
  ['the tour', /driver-popover/],
  ['glTF', /EXT_mesh_gpu_instancing/],
  ['video', /mediabunny/i],
];

const isScript = (response: Response): boolean =>
  /javascript/.test(response.headers()['content-type'] ?? '') || /\.m?js(\?|$)/.test(response.url());

test('less than 350 kB of JavaScript travel before the first tree moves, and what is not needed yet is not among them', async ({
  page,
}) => {
  const responses: Response[] = [];
  const take = (response: Response): void => {
    if (isScript(response)) responses.push(response);
  };
  page.on('response', take);
  await page.goto('./');
  test.skip((await page.locator('script[src*="@vite"]').count()) > 0, 'only what is built has the size that ships');
  await ready(page);
  page.off('response', take);

  const scripts = await Promise.all(
    responses.map(async (response) => ({ url: new URL(response.url()).pathname, text: await response.text() })),
  );
  const sizes = scripts.map(({ url, text }) => ({ url, bytes: gzipSync(text, { level: 9 }).length }));
  // The page and the worker that grows trees: nothing moves without both.
  expect(sizes.map(({ url }) => url).filter((url) => /grow\.worker/.test(url))).toHaveLength(1);
  const sum = sizes.reduce((all, { bytes }) => all + bytes, 0);
  console.log(`first load: ${sum} bytes of JavaScript, gzipped, in ${sizes.length} files`);
  expect(sum, JSON.stringify(sizes)).toBeGreaterThan(100_000);
  expect(sum, JSON.stringify(sizes)).toBeLessThan(BUDGET);

  const all = scripts.map(({ text }) => text).join('\n');
  expect(LATER.filter(([, code]) => code.test(all)).map(([name]) => name)).toEqual([]);

  // They do come: the panels by themselves, the rest when it is opened.
  await expect(page.getByRole('link', { name: /Black Tupelo/ })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('combobox', { name: 'Species', exact: true })).toBeVisible();
  await page.keyboard.press('Control+k');
  await expect(page.getByRole('combobox', { name: 'Find a command' })).toBeFocused();
});
