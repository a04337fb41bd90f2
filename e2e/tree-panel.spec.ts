import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';
import { BARE, inBothThemes, open, ready, settled, state } from './editor-page.ts';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** What axe finds wrong with the panel, as rule: places. */
async function faults(page: Page): Promise<string[]> {
  await page.addScriptTag({ path: axe });
  return page.evaluate(async () => {
    const { axe } = window as unknown as {
      axe: { run(of: string): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    return (await axe.run('wg-tree')).violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ')}`);
  });
}

const edits = async (page: Page) => (await state(page)).edits;
const slider = (page: Page, name: string) => page.getByRole('slider', { name, exact: true });
const box = (page: Page, name: string) => page.getByRole('spinbutton', { name, exact: true });
const row = (page: Page, path: string) => page.locator(`.parameter[data-path="${path}"]`);
const section = (page: Page, name: string) => page.locator(`.tree-fold[data-section="${name}"] > summary`);

test('arrows, Shift, typing and a wrong value, a double click, reset', async ({ page }) => {
  const complaints = await open(page, BARE);
  const down = slider(page, 'Limbs: Down angle');
  await down.press('ArrowRight');
  expect(await edits(page)).toEqual({ 'levels.1.downAngle': 61 });
  await down.press('Shift+ArrowLeft');
  expect(await edits(page)).toEqual({ 'levels.1.downAngle': 51 });
  await box(page, 'Limbs: Down angle, degrees').press('Shift+ArrowUp');
  await box(page, 'Limbs: Down angle, degrees').press('ArrowDown');
  expect(await edits(page)).toEqual({}); // 61 - 1 is what the species has: no edit
  await box(page, 'Limbs: Down angle, degrees').fill('-33');
  await box(page, 'Limbs: Down angle, degrees').press('Enter');
  expect(await edits(page)).toEqual({ 'levels.1.downAngle': -33 });
  await expect(down).toHaveAttribute('min', '-40'); // beyond the slider's comfort, and on it
  await expect(
    row(page, 'levels.1.downAngle').getByRole('button', { name: 'Limbs: Down angle, changed from 60° ± -50°' }),
  ).toBeVisible();

  const typed = box(page, 'Limbs: Down angle, degrees');
  await typed.fill('1000');
  await typed.press('Enter');
  await expect(row(page, 'levels.1.downAngle').getByRole('alert')).toHaveText(
    'Allowed: a number from -360 to 360 degrees.',
  );
  await expect(typed).toHaveValue('-33');
  await down.dblclick({ position: { x: 4, y: 16 } });
  expect(await edits(page)).toEqual({});
  await expect(row(page, 'levels.1.downAngle').getByRole('alert')).toHaveCount(0);

  await slider(page, 'Size').press('ArrowRight');
  await page.getByRole('button', { name: 'Reset Size to 13.0 m ± 3.0 m' }).click();
  expect(await edits(page)).toEqual({});
  await settled(page);
  expect(complaints).toEqual([]);
});

test('what is locked stays with another species; reset all keeps it; a name of its own', async ({ page }) => {
  await open(page, BARE);
  await box(page, 'Limbs: Length, typed').fill('0.5');
  await box(page, 'Limbs: Length, typed').press('Enter');
  await box(page, 'Limbs: Number of limbs, typed').fill('20');
  await box(page, 'Limbs: Number of limbs, typed').press('Enter');
  await page.getByRole('button', { name: /^Limbs: Length/ }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Lock' }).click();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toBeHidden();
  await page.getByRole('textbox', { name: 'Name of this tree' }).fill('My aspen');
  await page.getByRole('textbox', { name: 'Name of this tree' }).press('Enter');
  expect((await state(page)).treeName).toBe('My aspen');
  await page.getByRole('button', { name: 'Reset all' }).click();
  expect(await edits(page)).toEqual({ 'levels.1.length': 0.5 });
  await page.getByRole('combobox', { name: 'Species', exact: true }).selectOption('Black Tupelo');
  await ready(page);
  expect(await edits(page)).toMatchObject({ 'levels.1.length': 0.5 });
  await page.getByRole('button', { name: 'Unlock all' }).click();
  await page.getByRole('button', { name: 'Reset all' }).click();
  expect(await edits(page)).toEqual({});
});

test('search, changed only, compare while the button is held', async ({ page }) => {
  await open(page, `${BARE}&levels.1.downAngle=80&bark.grain=0.2`);
  await page.locator('body').press('/');
  const search = page.getByRole('searchbox', { name: 'Find a parameter' });
  await expect(search).toBeFocused();
  await search.fill('down angle');
  await expect(page.locator('.parameter')).toHaveCount(5); // four levels, and the leaves
  await page.getByRole('checkbox', { name: 'Changed only' }).check();
  await expect(page.locator('.parameter')).toHaveCount(1);
  await search.fill('');
  await expect(page.locator('.parameter')).toHaveCount(2);
  await expect(page.getByText('2 changes')).toBeVisible();
  await search.fill('xyz');
  await expect(page.getByText('No parameter is called so', { exact: false })).toBeVisible();
  await search.fill('');

  const before = page.getByRole('button', { name: 'Before' });
  await before.focus();
  await page.keyboard.down('Space');
  await expect(before).toHaveAttribute('aria-pressed', 'true');
  expect(await edits(page)).toMatchObject({ 'levels.1.downAngle': 80 });
  await page.keyboard.up('Space');
  await expect(before).toHaveAttribute('aria-pressed', 'false');
  expect((await state(page)).paused).toBe(true); // Space did not play
});

test('levels by tabs and side by side; a label explains; what does nothing says why', async ({ page }) => {
  await open(page, BARE);
  await page.getByRole('tab', { name: 'Limbs' }).press('ArrowLeft');
  await expect(page.getByRole('tab', { name: 'Trunk' })).toBeFocused();
  await expect(row(page, 'tree.lobeDepth')).toBeVisible();
  await expect(row(page, 'levels.0.splitAngle')).toContainText('Nothing splits');
  await box(page, 'Trunk: Splits, typed').fill('0.5');
  await box(page, 'Trunk: Splits, typed').press('Enter');
  await expect(row(page, 'levels.0.splitAngle')).not.toContainText('Nothing splits');

  await page.getByRole('button', { name: /^Trunk: Taper/ }).click();
  const help = page.getByRole('dialog');
  await expect(help).toContainText('0 cylinder, 1 cone');
  await expect(help).toContainText('0Taper, Weber & Penn 1995, 4.4');
  await expect(help.locator('img')).toHaveCount(
    await page.evaluate(async () => ((await (await fetch('help/index.json')).json())['levels.taper'] ? 2 : 0)),
  );
  await page.keyboard.press('Escape');
  await expect(page.getByRole('button', { name: /^Trunk: Taper/ })).toBeFocused();

  await page.getByRole('radio', { name: 'Side by side' }).check({ force: true });
  await box(page, 'Branches: Length, typed').fill('0.7');
  await box(page, 'Branches: Length, typed').press('Enter');
  expect(await edits(page)).toMatchObject({ 'levels.2.length': 0.7 });
  await page.getByRole('button', { name: 'Reset stems, level by level' }).click();
  expect(await edits(page)).toEqual({});
});

test('the crown and the envelope are drawn as curves, by keyboard and by mouse', async ({ page }) => {
  await open(page, BARE);
  await page.getByRole('button', { name: 'Draw the crown as a curve' }).click();
  const top = slider(page, 'Length of limbs at the top');
  await expect(top).toHaveAttribute('aria-valuetext', '50 per cent');
  await top.press('Shift+ArrowRight');
  await top.press('ArrowLeft');
  expect(((await edits(page))['tree.crown'] as number[]).at(-1)).toBe(0.59);
  const point = (await top.boundingBox())!;
  await page.mouse.move(point.x + point.width / 2, point.y + point.height / 2);
  await page.mouse.down();
  await page.mouse.move(point.x + point.width / 2 + 12, point.y + point.height / 2, { steps: 3 });
  await page.mouse.up();
  expect(((await edits(page))['tree.crown'] as number[]).at(-1)).toBeGreaterThan(0.65);
  await page.getByRole('button', { name: 'Back to the crown shape' }).click();
  expect(await edits(page)).toEqual({});

  await section(page, 'pruning').click();
  await page.getByRole('button', { name: 'Prune the tree to an envelope' }).click();
  await slider(page, 'Widest place of the envelope').press('Shift+ArrowLeft');
  await slider(page, 'Widest place of the envelope').press('Shift+ArrowUp');
  await slider(page, 'Curve of the envelope above its widest place').press('Shift+ArrowLeft');
  expect(await edits(page)).toEqual({
    'pruning.ratio': 1,
    'pruning.width': 0.4,
    'pruning.widthPeak': 0.6,
    'pruning.powerHigh': 0.7,
  });
  await settled(page);
});

test('axe finds nothing in both themes, at 1280 and at 320 pixels', async ({ page }) => {
  const faultless = () => inBothThemes(page, async (theme) => expect(await faults(page), theme).toEqual([]));
  await page.setViewportSize({ width: 1280, height: 720 });
  await open(page, `${BARE}&levels.1.downAngle=80&tree.crown=0.5,0.8,0.2`);
  for (const name of ['leaves', 'pruning', 'bark', 'foliage', 'wind', 'switches']) await section(page, name).click();
  await expect(page.locator('.parameter').first()).toBeVisible();
  await faultless();
  await page.getByRole('button', { name: /^Limbs: Down angle/ }).click();
  await expect(page.getByRole('dialog')).toBeVisible();
  await faultless();
  await page.keyboard.press('Escape');
  await page.setViewportSize({ width: 320, height: 640 });
  await expect(page.getByRole('region', { name: 'Controls' })).toBeVisible();
  await expect(page.locator('.parameter').first()).toBeAttached();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
  // No row is wider than the panel that holds it.
  const wide = await page.evaluate(() => {
    const { right } = document.querySelector('wg-tree')!.getBoundingClientRect();
    return [...document.querySelectorAll('wg-tree .parameter *')]
      .filter((e) => e.checkVisibility() && !e.closest('.spoken') && e.getBoundingClientRect().right > right + 1)
      .map((e) => e.outerHTML.slice(0, 90));
  });
  expect(wide).toEqual([]);
  await faultless();
  await page.getByRole('radio', { name: 'Side by side' }).check({ force: true });
  await expect(page.locator('.level-table')).toBeVisible();
  await faultless();
});
