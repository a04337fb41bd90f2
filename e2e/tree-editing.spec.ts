import { expect, type Locator, type Page, test } from '@playwright/test';
import { address, BARE, open, ready, state, tips } from './editor-page.ts';

/** A parameter's row in the panel, by its path. */
const row = (page: Page, path: string): Locator => page.locator(`[data-path="${path}"]`);
const typed = (page: Page, path: string): Locator => row(page, path).locator('input[type="number"]').first();

/** Puts the mouse on the thumb of a slider, and gives where the slider is. */
async function grab(page: Page, slider: Locator): Promise<{ x: number; y: number; width: number }> {
  await slider.scrollIntoViewIfNeeded();
  const box = (await slider.boundingBox())!;
  const part = await slider.evaluate((e: HTMLInputElement) => (+e.value - +e.min) / (+e.max - +e.min));
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + 8 + part * (box.width - 16), y);
  await page.mouse.down();
  return { x: box.x, y, width: box.width };
}

test('a number that is typed makes another tree, which the link carries and a reset takes back; one that is too much is told', async ({
  page,
}) => {
  const complaints = await open(page, BARE);
  const before = await tips(page);
  await typed(page, 'tree.scale').fill('20');
  await page.keyboard.press('Enter');
  await ready(page);
  expect((await state(page)).edits).toEqual({ 'tree.scale': 20 });
  const grown = await tips(page);
  expect(grown).not.toEqual(before);
  expect(Math.max(...grown)).toBeGreaterThan(1.3 * Math.max(...before));
  const link = await address(page, /tree\.scale=20/);
  expect(link.get('s')).toBe('quaking-aspen');

  // Bit for bit the same after a reload, and for whoever gets the link.
  await page.reload();
  await ready(page);
  expect(await tips(page)).toEqual(grown);
  await expect(typed(page, 'tree.scale')).toHaveValue(/^20(\.0+)?$/);

  // What cannot be is put back.
  await typed(page, 'tree.scale').fill('1000');
  await page.keyboard.press('Enter');
  expect((await state(page)).edits).toEqual({ 'tree.scale': 20 });

  await page.evaluate(() => {
    location.hash = location.hash.replace('tree.scale=20', 'tree.scale=20&tree.flare=2');
  });
  await expect.poll(async () => (await state(page)).edits).toEqual({ 'tree.scale': 20, 'tree.flare': 2 });
  await ready(page);
  await page.getByRole('button', { name: 'Reset all' }).click();
  await ready(page);
  expect((await state(page)).edits).toEqual({});
  expect(await tips(page)).toEqual(before);
  await address(page, /#s=quaking-aspen&seed=3&t=2/);

  await page.evaluate(() => {
    location.hash += '&levels.1.branches=90000&levels.2.branches=90000';
  });
  const message = page.getByRole('alert').filter({ hasText: 'could not be grown' });
  await expect(message).toContainText('the limit is');
  await ready(page);
  expect((await state(page)).edits).toEqual({});
  expect(await tips(page)).toEqual(before);
  expect(complaints).toEqual([]);
});

test('trees follow a hand that is quicker than they grow; the last one is whole and the one that was wished', async ({
  page,
}) => {
  const complaints = await open(page, BARE);
  await page.evaluate(() => {
    const { session } = (document.querySelector('wg-app') as unknown as { editor: Editor }).editor;
    const seen: number[] = [];
    Object.assign(window, { seen });
    session.subscribe((now, was) => now.tree !== was.tree && seen.push(now.tree!.species.tree.scale));
    interface Editor {
      session: { subscribe(listener: (now: Tree, was: Tree) => void): void };
    }
    interface Tree {
      tree: { species: { tree: { scale: number } } } | null;
    }
  });
  const slider = row(page, 'tree.scale').locator('input[type="range"]').first();
  const { x, y, width } = await grab(page, slider);
  for (let i = 0; i <= 24; i++) await page.mouse.move(x + width * (0.3 + 0.0125 * i), y);
  await page.mouse.up();
  await ready(page);
  const { edits } = await state(page);
  const wished = edits['tree.scale'] as number;
  const seen = await page.evaluate(() => (window as unknown as { seen: number[] }).seen);
  expect(seen.at(-1)).toBe(wished);
  // Some on the way, in the order of the hand, and by far not all: the latest wins.
  expect(seen.length).toBeGreaterThan(1);
  expect(seen).toEqual([...seen].sort((a, b) => a - b));
  const dragged = await tips(page);
  await page.goto('about:blank');
  await open(page, `${BARE}&tree.scale=${wished}`);
  expect(await tips(page)).toEqual(dragged);
  expect(complaints).toEqual([]);
});

test('a tree that is stopped while it grows leaves the last one, its numbers and its link', async ({ page }) => {
  const complaints = await open(page, `${BARE}&tree.flare=2&called=Old%20friend`);
  const before = await tips(page);
  let go = (): void => {};
  const held = new Promise<void>((done) => {
    go = done;
  });
  await page.route('**/weeping-willow.json', async (route) => {
    await held;
    await route.continue();
  });
  await page.getByRole('combobox', { name: 'Species', exact: true }).selectOption('Weeping Willow');
  await page.getByText('Growing Weeping Willow…').waitFor();
  await page.getByRole('button', { name: 'Stop', exact: true }).click();
  await ready(page);
  go();
  expect(await state(page)).toMatchObject({
    species: 'quaking-aspen',
    edits: { 'tree.flare': 2 },
    treeName: 'Old friend',
  });
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Old friend');
  expect(await tips(page)).toEqual(before);
  await address(page, /s=quaking-aspen.*tree\.flare=2.*called=Old%20friend/);
  expect(complaints).toEqual([]);
});
