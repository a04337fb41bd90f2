import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';
import { open, ready, settled, state } from './editor-page.ts';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** What axe finds wrong with the drawer, as rule: first place. */
const faults = (page: Page): Promise<string[]> =>
  page.evaluate(async () => {
    const { axe } = window as unknown as {
      axe: { run(within: string): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    return (await axe.run('wg-studio')).violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ')}`);
  });

/** The limbs of an aspen without leaves, standing still in the middle of a breeze. */
const STILL = 'seed=3&t=20&paused=1&levels=2&leaves=0';

/** Opens the page with the drawer open at a tab. */
async function studio(page: Page, tab: string, link = STILL): Promise<string[]> {
  await page.addInitScript(() => {
    localStorage.setItem('windgrove', JSON.stringify({ visited: true, folds: { studio: true } }));
  });
  const complaints = await open(page, link);
  await page.getByRole('tab', { name: tab, exact: true }).click();
  return complaints;
}

/** Rows of a file that the page gives: the header, then numbers. */
async function saved(page: Page, button: string): Promise<{ header: string[]; rows: number[][] }> {
  const waiting = page.waitForEvent('download');
  await page.getByRole('button', { name: button, exact: true }).click();
  const text = await readFile(await (await waiting).path(), 'utf8');
  const [header, ...rows] = text.trimEnd().split('\r\n');
  return { header: header!.split(','), rows: rows.map((row) => row.split(',').map(Number)) };
}

test('plots the probe, says in words what it plots, and agrees with the GPU', async ({ page }) => {
  const complaints = await studio(page, 'Plots');
  await expect(page.locator('wg-studio-plots .uplot')).toHaveCount(5);
  const summary = page.locator('.summary-text');
  await expect(summary).toContainText('The last 20 seconds: the wind at the probe has a mean of');
  await expect(summary).toContainText('by itself swings at');

  // What the file holds is what was seen: the last reading is of this moment, and what moves there moves in the picture.
  const { header, rows } = await saved(page, 'Download CSV');
  expect(header.slice(0, 4)).toEqual(['time (s)', 'force (m/s)', 'force across (m/s)', 'displacement along (m)']);
  expect(rows).toHaveLength(20 * 60 + 1);
  expect(rows.at(-1)![0]).toBeCloseTo(20, 3);
  expect(Math.max(...rows.map((row) => Math.abs(row[3]!)))).toBeGreaterThan(1e-3);

  // A step later it has been held against the GPU's own piece.
  await page.evaluate(() => window.windgrove!.step(1));
  await settled(page);
  const trust = page.locator('.trust');
  await expect(trust).toContainText(/had the branch’s end [\d.]+\u2009µm from/);

  // Pointing at one plot marks the same time in all of them.
  await page.locator('#force-plot .u-over').hover({ position: { x: 120, y: 10 } });
  const read = page.locator('#velocity-reading');
  await expect(read).toHaveText(/^\d+\.\d\d\u2009s: /);
  const time = (await read.textContent())!.split('\u2009')[0]!;
  await expect(page.locator('#displacement-reading')).toContainText(time);

  await page.getByRole('button', { name: 'Data table' }).click();
  await expect(page.getByRole('table').getByRole('row')).toHaveCount(22);
  expect(complaints).toEqual([]);
});

test('throws a gust from the map, and finds branches in the textures and textures in branches', async ({ page }) => {
  await studio(page, 'Field');
  const map = page.getByRole('application', { name: /Map of the wind/ });
  await expect(page.locator('#field-reading')).toContainText('At the tree');
  const box = (await map.boundingBox())!;
  await map.click({ position: { x: box.width / 4, y: box.height / 2 } });
  const { gusts } = (await state(page)).wind;
  expect(gusts).toHaveLength(1);
  // From 15 m to the left of the tree towards it.
  expect(gusts[0]!.x).toBeCloseTo(-15, 0);
  expect(Math.cos(gusts[0]!.direction)).toBeCloseTo(1, 2);

  await page.getByRole('tab', { name: 'Textures' }).click();
  const image = page.getByRole('application', { name: /^Texture P3/ });
  await image.press('ArrowRight');
  await expect(page.locator('.texel-values')).toContainText(/Piece \d+/);
  const piece = Number(/Piece (\d+)/.exec((await page.locator('.texel-values').textContent())!)![1]);
  await image.press('Enter');
  expect((await state(page)).probe).toBe(piece);
  await page.getByRole('radio', { name: 'x y z as colours' }).check();
  await page.getByRole('radio', { name: 'Q', exact: true }).check();
  await expect(page.locator('.texel-values')).toContainText('velocity T');
});

test('compares two models on one tree, and swaps them', async ({ page }) => {
  const complaints = await studio(page, 'Compare');
  await page.getByRole('button', { name: 'Springs against direct' }).click();
  await expect(page.locator('.compare-words')).toContainText(/B differs from A by [\d.]+\u2009mm/);
  expect((await state(page)).compare!.wind.model).toBe('direct');
  await page.getByRole('button', { name: 'Swap' }).click();
  const swapped = await state(page);
  expect([swapped.wind.model, swapped.compare!.wind.model]).toEqual(['direct', 'spring']);
  const { header, rows } = await saved(page, 'Download CSV');
  expect(header).toEqual(['time (s)', 'displacement A (m)', 'displacement B (m)', 'B less A (m)']);
  for (const [, a, b, difference] of rows) expect(b! - a!).toBeCloseTo(difference!, 6);
  await page.getByRole('button', { name: 'Copy A to B' }).click();
  await expect(page.locator('.compare-words')).toContainText('differs from A by 0.00');
  await page.getByRole('button', { name: 'A alone' }).click();
  await expect(page.getByRole('button', { name: 'Direct against springs' })).toBeVisible();
  expect(complaints).toEqual([]);
});

test('plays a measured wind, and says what is wrong with a file that is none', async ({ page }) => {
  await studio(page, 'Anemometer');
  const file = page.locator('wg-studio-anemometer input[type="file"]');
  const csv = (text: string) => ({ name: 'mast.csv', mimeType: 'text/csv', buffer: Buffer.from(text) });
  await file.setInputFiles(csv('time (s),speed (m/s)\n0,3\n1,windy\n2,4\n'));
  const message = page.getByRole('alert').filter({ hasText: 'mast.csv was not opened' });
  await expect(message).toContainText('windy');
  expect((await state(page)).wind.record).toBeNull();

  await file.setInputFiles(csv('time (s),speed (m/s),direction (deg)\n0,3,270\n1,5,265\n2,4,275\n'));
  await expect(message).toHaveCount(0);
  await expect(page.locator('.anemometer-side')).toContainText('mast: 3 samples');
  await page.getByRole('button', { name: 'Play it alone' }).click();
  const { wind } = await state(page);
  expect(wind.record!.speed).toEqual([3, 5, 4]);
  expect(wind.waves.some(({ on }) => on)).toBe(false);
  await page.getByRole('button', { name: 'Stop it' }).click();
  expect((await state(page)).wind.record).toBeNull();
});

test('can be used with keys alone, and gives screen readers what it shows', async ({ page }) => {
  await studio(page, 'Plots');
  await page.getByRole('tab', { name: 'Plots' }).press('ArrowRight');
  await expect(page.getByRole('tab', { name: 'Field' })).toBeFocused();
  await page.addScriptTag({ path: axe });
  for (const tab of ['Plots', 'Field', 'Textures', 'Compare', 'Anemometer']) {
    await page.getByRole('tab', { name: tab, exact: true }).click();
    await expect(page.locator(`wg-studio-${tab.toLowerCase()}`)).toBeVisible();
    expect([tab, ...(await faults(page))]).toEqual([tab]);
  }
  // Closed, nothing of it is there to be drawn.
  await page.getByRole('button', { name: 'Wind studio' }).click();
  await expect(page.locator('wg-studio canvas')).toHaveCount(0);
});

test('marks in the picture what it listens to, and is pulled to another height', async ({ page }) => {
  await open(page, STILL);
  await page.mouse.move(2, 2);
  const overlay = (): Promise<string> => page.evaluate(() => window.windgrove!.picture());
  const before = await overlay();
  await page.getByRole('button', { name: 'Wind studio' }).click();
  await expect(page.locator('wg-studio-plots .uplot')).toHaveCount(5);
  await settled(page);
  expect(await overlay()).not.toBe(before);
  // Where there is room the map stands beside the plots, at the time that they mark.
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.locator('#force-plot .u-over').hover({ position: { x: 120, y: 10 } });
  const time = (await page.locator('#force-reading').textContent())!.split('\u2009')[0]!;
  await expect(page.locator('wg-studio-field[small] #field-reading')).toContainText(time);
  const body = page.locator('#studio-panel');
  const height = (await body.boundingBox())!.height;
  await page.getByRole('separator', { name: 'Height of the wind studio' }).press('ArrowUp');
  expect((await body.boundingBox())!.height).toBeCloseTo(height + 16, 0);
  await page.reload();
  await ready(page);
  expect((await body.boundingBox())!.height).toBeCloseTo(height + 16, 0);
});

test('is a tab of the sheet on a phone, without scrolling sideways', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, STILL);
  await ready(page);
  await page.getByRole('tab', { name: 'Studio' }).click();
  await expect(page.locator('wg-studio-plots .uplot')).toHaveCount(5);
  const wide = await page.evaluate(() => {
    const { scrollWidth, clientWidth } = document.querySelector('#tab-panel')!;
    return scrollWidth - clientWidth;
  });
  expect(wide).toBeLessThanOrEqual(0);
});
