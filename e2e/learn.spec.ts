import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

test.use({ viewport: { width: 1000, height: 700 } });

const ready = (page: Page) =>
  page.waitForFunction(() => document.documentElement.dataset.ready === 'true', null, { timeout: 60_000 });

const complaints = async (page: Page): Promise<string[]> =>
  page.evaluate(async () => {
    const { axe } = window as unknown as {
      axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    return (await axe.run()).violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ')}`);
  });

test('a lesson works with keyboard and mouse, keeps a figure in its address, and axe finds nothing in both themes', async ({
  page,
}) => {
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.message));
  await page.emulateMedia({ reducedMotion: 'reduce' });
  // A figure in the address is scrolled to: the tree above it, which software GL draws slowly, is not near.
  await page.goto('learn/weber-penn.html#fig=curve&curve=50');
  await ready(page);
  const figure = page.locator('figure[data-figure="curve"]');
  const turn = figure.locator('dd').first();
  await expect(turn).toHaveText('130.0°');
  await figure.getByRole('slider', { name: 'nCurve', exact: true }).press('ArrowRight');
  await expect(turn).toHaveText('131.0°');
  expect(page.url()).toContain('#fig=curve&curve=51');

  const handle = figure.getByRole('button', { name: /Tip of the stem/ });
  await handle.press('ArrowUp');
  const typed = figure.getByRole('spinbutton', { name: 'nCurve, typed', exact: true });
  await expect(typed).not.toHaveValue('51');
  const place = (await handle.boundingBox())!;
  const [x, y] = [place.x + place.width / 2, place.y + place.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 200, y - 60, { steps: 4 });
  await page.mouse.up();
  const dragged = Number(await typed.inputValue());
  expect(dragged).toBeLessThan(20);
  expect(page.url()).toContain(`curve=${dragged}`);

  await page.reload();
  await ready(page);
  await expect(typed).toHaveValue(String(dragged));
  await figure.getByText('nCurve', { exact: true }).dblclick();
  await expect(typed).toHaveValue('40');
  await expect(figure.getByRole('img')).toHaveAccessibleName(/turns by 40 degrees/);

  // A handle that goes round: along its own arrow there is no way to go.
  const attraction = page.locator('figure[data-figure="attraction"]');
  await attraction.scrollIntoViewIfNeeded();
  await attraction.getByRole('button', { name: /^Direction in which the stem begins/ }).press('ArrowLeft');
  const start = attraction.getByRole('spinbutton', { name: 'Begins at, typed', exact: true });
  await expect(start).toHaveValue('91');
  await attraction.getByRole('button', { name: 'Reset', exact: true }).click();
  await expect(start).toHaveValue('90');

  await page.addScriptTag({ path: axe });
  expect(await complaints(page)).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  expect(await complaints(page)).toEqual([]);
  expect(errors).toEqual([]);
});

test('the lessons are complete without JavaScript: text, formulas, captions, code that leads to its file, the next lesson', async ({
  browser,
}, { project }) => {
  const context = await browser.newContext({ ...project.use, javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto('learn/index.html');
  await page.locator('.cards a').first().click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Growing a tree');
  await expect(page.locator('.equation math').first()).toBeAttached();
  const captions = page.locator('figure.live figcaption');
  for (const caption of await captions.all()) await expect(caption).toBeVisible();
  expect(await captions.count()).toBeGreaterThan(6);
  await page.locator('details summary').first().click();
  await expect(page.locator('details > p').first()).toBeVisible();
  const line = page.locator('.source-lines a').first();
  const anchor = new URL((await line.getAttribute('href'))!, page.url()).hash;
  await line.click();
  await expect(page.locator(anchor)).toBeVisible();
  await page.goBack();
  await page.getByRole('link', { name: /^Next: 2/ }).click();
  await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
  expect(page.url()).toContain('branch-deformer');
  await context.close();
});
