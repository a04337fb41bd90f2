import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';
import { beforeFirstPaint, siteIn } from '../tests/site/built-site.ts';
import { siteFaults } from '../tests/site/link-check.ts';
import { BARE, ready } from './editor-page.ts';
import { serve } from './static-server.ts';

const build = process.env.WINDGROVE_TEST_BUILD;
const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** Bytes, packed, that a page may have before anything of it is seen: its HTML and style sheets. */
const BUDGETS: readonly (readonly [RegExp, number])[] = [
  [/^learn\//, 48_000],
  [/^reference\/[\w-]+\.html$/, 24_000],
  [/^viewer\.html$/, 4_000],
  [/^(?:index|forest|range|bench|crosscheck)\.html$/, 16_000],
];

test.skip(!build, 'only what is built is a site');

test('every link of the site leads somewhere, every page says what it is and can be reached, and little stands before its first paint', () => {
  const site = siteIn(build!);
  expect(siteFaults(site)).toEqual([]);
  const pages = site.files.filter((file) => BUDGETS.some(([pattern]) => pattern.test(file)));
  expect(pages.length).toBeGreaterThan(15);
  const late = pages.flatMap((page) => {
    const { bytes, blocking } = beforeFirstPaint(site, page);
    const [, budget] = BUDGETS.find(([pattern]) => pattern.test(page))!;
    return bytes > budget || blocking.length > 0 ? [`${page}: ${bytes} bytes of ${budget}; ${blocking.join()}`] : [];
  });
  expect(late).toEqual([]);
});

/** What axe finds wrong with the page. */
async function wrong(page: Page): Promise<string[]> {
  await page.addScriptTag({ path: axe });
  return page.evaluate(async () => {
    const { axe } = window as unknown as {
      axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    return (await axe.run()).violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ')}`);
  });
}

test('axe finds nothing in the reference pages at 320 pixels, in both themes; a parameter is found by a word', async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 600 });
  for (const name of ['index', 'wind', 'element', 'embedding', 'formats', 'parameters']) {
    await page.goto(`reference/${name}.html`);
    for (const colorScheme of ['light', 'dark'] as const) {
      await page.emulateMedia({ colorScheme });
      expect(await wrong(page), `${name}, ${colorScheme}`).toEqual([]);
    }
    expect(await page.evaluate(() => document.documentElement.scrollWidth), name).toBeLessThanOrEqual(320);
  }
  const entries = page.locator('.parameter:visible');
  await page.getByRole('searchbox', { name: 'Find a parameter' }).fill('flare');
  await expect(entries).toHaveCount(1);
  await entries.getByRole('link', { name: 'Link to Flare' }).click();
  await expect(page).toHaveURL(/#tree\.flare$/);
  await expect(page.getByRole('searchbox')).toHaveValue('');
});

test.describe('without a network', () => {
  test.use({ serviceWorkers: 'allow', contextOptions: { reducedMotion: 'reduce' } });

  test('a page that was seen and the editor with its species are there; another says why not, and leads back', async ({
    page,
  }) => {
    const host = await serve(build!, '/trees/');
    await page.goto(`${host.url}reference/index.html`);
    await expect(page.locator('html')).toHaveAttribute('data-kept', 'true', { timeout: 60_000 });
    // A page that there is not leads home from any depth, in whatever folder the site stands.
    await page.goto(`${host.url}no/such/page.html`);
    await expect(page.getByRole('heading', { name: 'No such page' })).toBeVisible();
    await expect(page.getByRole('link', { name: 'Editor' })).toHaveJSProperty('href', `${host.url}index.html`);

    await host.stop();
    await page.goto(`${host.url}reference/index.html?again=1`);
    await expect(page.getByRole('heading', { name: 'Reference' })).toBeVisible();
    await expect(page.locator('nav.site')).toHaveCSS('display', 'flex');
    await page.goto(`${host.url}learn/range.html`);
    await expect(page.getByRole('heading', { name: 'No network' })).toBeVisible();
    await expect(page.getByRole('link', { name: 'Editor' })).toHaveJSProperty('href', `${host.url}index.html`);
    await page.goto(`${host.url}index.html#s=silver-birch&${BARE}`);
    await ready(page);
    await page.reload();
    await ready(page);
  });
});
