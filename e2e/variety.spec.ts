import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';
import type { Editor } from '../src/editor/editor.ts';
import { BARE, inBothThemes, open, ready, state } from './editor-page.ts';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** A tree of two levels without leaves: twelve of them are grown and drawn fast. */
const SMALL = `${BARE}&tree.levels=2`;

const dialog = (page: Page) => page.getByRole('dialog');

async function openDialog(page: Page, tab?: string): Promise<void> {
  await page.keyboard.press('m');
  await expect(page.getByRole('tab', { name: 'Seeds' })).toBeFocused();
  if (tab) await page.getByRole('tab', { name: tab }).click();
}

test('a seed, by keyboard alone; undo brings the last tree back, redo this one', async ({ page }) => {
  const complaints = await open(page, SMALL);
  await openDialog(page);
  const seeds = page.getByRole('group', { name: 'Twelve seeds' }).getByRole('radio');
  await expect(seeds).toHaveCount(12);
  // Every card gets its portrait, and no two are the same.
  await expect(page.locator('.card [data-drawn]')).toHaveCount(12, { timeout: 90_000 });
  const pictures = await page
    .locator('.card image')
    .evaluateAll((all) =>
      Promise.all(all.map(async (image) => (await fetch(image.getAttribute('href')!)).text())).then(
        (t) => new Set(t).size,
      ),
    );
  expect(pictures).toBe(12);
  await page.keyboard.press('Tab');
  await expect(page.getByRole('radio', { name: 'seed 3' })).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('radio', { name: 'seed 9' })).toBeChecked();
  await page.keyboard.press('ArrowLeft');
  await expect(page.getByRole('radio', { name: 'seed 8' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(dialog(page)).toBeHidden();
  await ready(page);
  expect((await state(page)).seed).toBe(8);
  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await state(page)).seed).toBe(3);
  await page.keyboard.press('Control+y');
  await expect.poll(async () => (await state(page)).seed).toBe(8);
  expect(complaints).toEqual([]);
});

test('twelve others, and back again', async ({ page }) => {
  await open(page, SMALL);
  await openDialog(page);
  await page.getByRole('button', { name: '12 others' }).click();
  await page.getByRole('radio', { name: 'seed 14' }).check();
  await page.getByRole('button', { name: '12 before' }).click();
  await expect(page.getByRole('radio', { name: 'seed 3' })).toBeChecked();
  await page.keyboard.press('Escape');
  await expect(dialog(page)).toBeHidden();
  expect((await state(page)).seed).toBe(3);
});

test('a variant of a variant is one step; what is locked stays', async ({ page }) => {
  await open(page, SMALL);
  await page.evaluate(() => {
    const { actions } = (document.querySelector('wg-app') as unknown as { editor: Editor }).editor;
    actions.toggleLock('tree.scale');
  });
  await openDialog(page, 'Variants');
  const variants = page.getByRole('group', { name: 'Twelve variants' }).getByRole('radio');
  await variants.nth(4).check();
  await page.getByRole('button', { name: 'Go on from this' }).click();
  await expect(page.getByRole('button', { name: 'Back', exact: true })).toBeEnabled();
  await expect(page.getByRole('button', { name: 'Take this tree' })).toBeDisabled();
  await variants.nth(1).check();
  await page.getByRole('button', { name: 'Take this tree' }).click();
  await expect(dialog(page)).toBeHidden();
  await ready(page);
  const { edits } = await state(page);
  expect(Object.keys(edits).length).toBeGreaterThan(10);
  expect(edits).toHaveProperty(['tree.baseSize']);
  expect(edits).not.toHaveProperty(['tree.scale']);
  await page.keyboard.press('Control+z');
  await expect.poll(async () => Object.keys((await state(page)).edits)).toEqual(['tree.levels']);
});

test('a blend is previewed while its share moves, and taken as a species of its own', async ({ page }) => {
  await open(page, SMALL);
  await openDialog(page, 'Blend');
  await page.getByRole('combobox', { name: 'Blend with' }).selectOption('Black Tupelo');
  const share = page.getByRole('slider', { name: 'Its share' });
  await share.focus();
  await share.press('Home');
  for (let i = 0; i < 3; i++) await share.press('Shift+ArrowRight');
  const preview = page.getByRole('figure', { name: 'Quaking Aspen × Black Tupelo 30 %' });
  await expect(preview).toBeVisible();
  await expect(preview.locator('[data-drawn]')).toBeVisible({ timeout: 60_000 });
  await page.getByRole('button', { name: 'Take this blend' }).click();
  await expect(dialog(page)).toBeHidden();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Quaking Aspen × Black Tupelo 30 %');
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Quaking Aspen');
});

test('axe finds nothing in both themes', async ({ page }) => {
  await open(page, SMALL);
  await page.addScriptTag({ path: axe });
  await openDialog(page);
  for (const tab of ['Seeds', 'Variants', 'Blend']) {
    await page.getByRole('tab', { name: tab }).click();
    await expect(page.locator('wg-variety svg').first()).toBeVisible();
    await inBothThemes(page, async (theme) => {
      const faults = await page.evaluate(async () => {
        const { axe } = window as unknown as {
          axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
        };
        return (await axe.run()).violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ')}`);
      });
      expect(faults, `${tab}, ${theme}`).toEqual([]);
    });
  }
});
