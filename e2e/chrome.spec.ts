import { expect, type Page, test } from '@playwright/test';
import { BARE, open, ready, settled, state } from './editor-page.ts';

/** Once the panels have come: the page holds still. */
const standing = async (page: Page): Promise<void> => {
  await expect(page.getByRole('slider', { name: 'Time', exact: true })).toBeVisible();
  await settled(page);
};

test('the palette finds commands, settings, species and winds, by keyboard alone', async ({ page }) => {
  const complaints = await open(page, `${BARE}&seed=7`);
  await standing(page);
  const box = page.getByRole('combobox', { name: 'Find a command' });
  const options = page.getByRole('listbox', { name: 'Found' }).getByRole('option');

  // A command: arrows go round, Enter takes the line that the box points at.
  await page.keyboard.press('Control+k');
  await expect(box).toBeFocused();
  await page.keyboard.type('wire');
  await expect(options.first()).toHaveText('WireframeW');
  await page.keyboard.press('ArrowUp');
  await expect(options.last()).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('ArrowDown');
  await expect(box).toHaveAttribute('aria-activedescendant', 'palette-command-wireframe');
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await state(page)).view).toBe('wireframe');
  await expect(page.getByRole('dialog')).toBeHidden();

  // A species and a wind.
  for (const [typed, key, value] of [
    ['tupelo', 'species', 'black-tupelo'],
    ['let gale', 'preset', 'gale'],
  ] as const) {
    await page.keyboard.press('Control+k');
    await expect(box).toHaveValue('');
    await page.keyboard.type(typed);
    await page.keyboard.press('Enter');
    await expect.poll(async () => (await state(page))[key]).toBe(value);
  }
  await ready(page);

  // A setting: its control has the focus, though its panel was folded away.
  await page.getByRole('button', { name: 'What grows' }).click();
  await page.keyboard.press('Control+k');
  await page.keyboard.type('down angle of twigs');
  await page.keyboard.press('Enter');
  await expect(page.locator('#p-levels-3-downAngle')).toBeFocused();

  // Nothing, and away again: the focus is back where it was.
  await page.keyboard.press('Control+k');
  await page.keyboard.type('qqqq');
  await expect(page.getByText('Nothing is called so')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.locator('#p-levels-3-downAngle')).toBeFocused();
  expect(complaints).toEqual([]);
});

test('keys undo, redo and open what the table says; a text box keeps its own', async ({ page }) => {
  await open(page, BARE);
  await standing(page);
  const undo = page.getByRole('button', { name: /^(Undo|Nothing to undo)/ });
  await expect(undo).toBeDisabled();

  await page.getByRole('spinbutton', { name: 'Seed' }).fill('11');
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await state(page)).seed).toBe(11);
  await expect(undo).toBeEnabled();
  // The number is taken: the key means the document. While one types it means the box.
  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await state(page)).seed).toBe(3);
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(async () => (await state(page)).seed).toBe(11);
  await page.getByRole('spinbutton', { name: 'Seed' }).fill('99');
  await page.keyboard.press('Control+z');
  expect((await state(page)).seed).toBe(11);
  await page.keyboard.press('Tab');
  await expect.poll(async () => (await state(page)).seed).not.toBe(3);

  // Every dialog opens by its key, says what it is, closes with Escape and by a click beside it.
  for (const [key, name] of [
    ['?', 'Keys and help'],
    ['y', 'History'],
    ['m', 'Other trees'],
    ['Control+e', 'Export'],
  ] as const) {
    await page.keyboard.press(key);
    await expect(page.getByRole('dialog', { name })).toBeVisible();
    if (key === '?') await page.mouse.click(8, 320);
    else await page.keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toBeHidden();
  }

  // The search of the settings, and back to the picture without leaving the keyboard.
  await page.keyboard.press('/');
  await expect(page.getByRole('searchbox')).toBeFocused();
  const { seed } = await state(page);
  await page.keyboard.type('d');
  expect((await state(page)).seed).toBe(seed);
  await expect(page.getByRole('searchbox')).toHaveValue('d');
});

test('the tour is offered once, goes by keyboard, and comes again from the help; the panel is as wide as it is pulled', async ({
  page,
}) => {
  await open(page, `${BARE}&theme=dark`);
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark');
  await standing(page);
  await page.getByRole('region', { name: 'Hint' }).getByRole('button', { name: 'Show me around' }).click();
  const tour = page.getByRole('dialog');
  await expect(tour).toContainText('A tree in the wind');
  await expect(page.getByRole('button', { name: 'Next' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(tour).toContainText('What grows');
  await page.keyboard.press('ArrowLeft');
  await expect(tour).toContainText('A tree in the wind');
  for (const title of ['What grows', 'Nothing is lost', 'What blows', 'Time is yours', 'Take it with you', 'Find']) {
    await page.keyboard.press('ArrowRight');
    await expect(tour).toContainText(title);
  }
  await page.getByRole('button', { name: 'Done' }).click();
  await expect(tour).toBeHidden();
  await expect(page.getByRole('button', { name: 'Keys and help' })).toBeFocused();

  const bar = (await page.getByRole('group', { name: 'Tree and view' }).boundingBox())!;
  expect(bar.height).toBeLessThan(44);
  expect(bar.x + bar.width).toBeLessThanOrEqual(1024);
  const edge = page.getByRole('separator', { name: 'Width of this panel' });
  const width = async (): Promise<number> => (await page.locator('.side.grow').boundingBox())!.width;
  const before = await width();
  await edge.press('ArrowRight');
  await edge.press('ArrowRight');
  expect(await width()).toBe(before + 32);

  await page.reload();
  await ready(page);
  await standing(page);
  await expect(page.getByRole('button', { name: 'Show me around' })).toBeHidden();
  expect(await width()).toBe(before + 32);
  await edge.dblclick();
  expect(await width()).toBe(before);
  await page.keyboard.press('?');
  await page.getByRole('button', { name: 'Show me around' }).click();
  await expect(tour).toContainText('1 of 7');
  await page.keyboard.press('Escape');
  await expect(tour).toBeHidden();
});

test('in a frame of another page there is the picture, play, and where it comes from', async ({ page }) => {
  await open(page, `${BARE}&embed=1`);
  await settled(page);
  await expect(page.getByRole('button')).toHaveCount(1);
  await page.getByRole('button', { name: 'Play' }).click();
  await expect.poll(async () => (await state(page)).paused).toBe(false);
  await page.getByRole('button', { name: 'Pause' }).click();
  const link = page.getByRole('link', { name: 'Windgrove' });
  await link.evaluate((a) => a.addEventListener('click', (e) => e.preventDefault()));
  await link.click();
  expect(await link.getAttribute('href')).not.toContain('embed');
  expect(await link.getAttribute('href')).toContain('seed=3');
  await page.keyboard.press('Control+k');
  await expect(page.getByRole('dialog')).toHaveCount(0);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('undo, play and one menu for the rest, with a finger', async ({ page }) => {
    const complaints = await open(page, BARE);
    await settled(page);
    await page.getByRole('button', { name: 'Play' }).first().tap();
    await expect.poll(async () => (await state(page)).paused).toBe(false);
    await page.getByRole('button', { name: 'Pause' }).first().tap();
    const menu = page.getByRole('group', { name: 'More', exact: true });
    for (const [item, dialog] of [
      ['Export…', 'Export'],
      ['Keys and help', 'Keys and help'],
    ] as const) {
      await page.getByRole('button', { name: 'More', exact: true }).tap();
      await menu.getByRole('button', { name: item }).tap();
      await expect(menu).toBeHidden();
      await expect(page.getByRole('dialog', { name: dialog })).toBeVisible();
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
      await page.getByRole('dialog').getByRole('button', { name: 'Close', exact: true }).tap();
      await expect(page.getByRole('button', { name: 'More', exact: true })).toBeFocused();
    }
    await page.getByRole('button', { name: 'More', exact: true }).tap();
    await menu.getByRole('button', { name: 'Show me around' }).tap();
    await expect(page.getByRole('dialog')).toContainText('1 of 6');
    await expect(menu).toBeHidden();
    await page.getByRole('button', { name: 'End the tour' }).tap();
    expect(complaints).toEqual([]);
  });
});
