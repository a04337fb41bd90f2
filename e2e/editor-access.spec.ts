import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';
import { BARE, inBothThemes, open, settled, state } from './editor-page.ts';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** What axe finds wrong with the page, as rule: first place. */
async function faults(page: Page): Promise<string[]> {
  await page.addScriptTag({ path: axe });
  return page.evaluate(async () => {
    const { axe } = window as unknown as {
      axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    return (await axe.run()).violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ')}`);
  });
}

/** Expects axe to find nothing in the page as it is, in either theme. */
const faultless = (page: Page, where: string): Promise<void> =>
  inBothThemes(page, async (theme) => expect(await faults(page), `${where}, ${theme}`).toEqual([]));

test('axe finds nothing in both themes, folds and help open', async ({ page }) => {
  await page.setViewportSize({ width: 1024, height: 640 });
  await open(page, `${BARE}&seed=-1`);
  await page.getByText('Statistics').click();
  for (const part of ['Wizard', 'Gusts', 'Branches answer', 'Level by level', 'Air and paper', 'Copy, paste, files']) {
    await page.getByText(part, { exact: true }).click();
  }
  await page.getByRole('button', { name: 'Wave 1: all settings' }).click();
  await page.getByRole('button', { name: 'Throw a gust' }).first().click();
  await page.getByRole('checkbox', { name: 'Limbs: frequency of its own' }).check();
  await page.getByRole('radio', { name: 'Logarithmic' }).check();
  await page.evaluate(() => {
    location.hash += '&compare=split,0.5';
  });
  await expect(page.getByRole('slider', { name: 'Line between A and B' })).toBeVisible();
  await faultless(page, 'folds');
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toBeVisible();
  await faultless(page, 'help');
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toBeHidden();
});

for (const theme of ['light', 'dark'] as const) {
  test(`axe finds nothing in the dialogs, the menus and the tour, ${theme}`, async ({ page }) => {
    await open(page, `${BARE}&theme=${theme}&seed=5`);
    await expect(page.getByRole('searchbox')).toBeVisible();
    for (const [key, name] of [
      ['Control+k', 'Find a command'],
      ['y', 'History'],
      ['m', 'Other trees'],
      ['Control+e', 'Export'],
    ] as const) {
      await page.keyboard.press(key);
      await expect(page.getByRole('dialog', { name })).toBeVisible();
      // What fills it has come, and nothing moves any more.
      await expect(page.getByText('Opening…')).toBeHidden();
      await page.evaluate(() => Promise.allSettled(document.getAnimations().map((a) => a.finished)));
      expect(await faults(page), name).toEqual([]);
      await page.keyboard.press('Escape');
      await expect(page.getByRole('dialog')).toBeHidden();
    }
    for (const name of ['File', 'Share', 'Theme']) {
      await page.getByRole('button', { name, exact: true }).click();
      await expect(page.locator(':popover-open')).toBeVisible();
      expect(await faults(page), name).toEqual([]);
      await page.keyboard.press('Escape');
    }
    await page.getByRole('button', { name: 'Show me around' }).click();
    await expect(page.getByRole('dialog')).toContainText('A tree in the wind');
    await page.evaluate(() => Promise.allSettled(document.getAnimations().map((a) => a.finished)));
    expect(await faults(page), 'tour').toEqual([]);
  });
}

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('the tree is above, the sheet below; its tabs, sliders and heights work with a finger', async ({ page }) => {
    const complaints = await open(page, BARE);
    await page.getByRole('button', { name: 'Got it' }).tap();
    const sheet = page.getByRole('region', { name: 'Controls' });
    const height = async (): Promise<number> => (await sheet.boundingBox())!.height / 844;
    expect(await height()).toBeLessThan(0.4);
    await page.getByRole('tab', { name: 'Wind', exact: true }).tap();
    const handle = page.getByRole('button', { name: /Height of the controls/ });
    await handle.tap();
    await expect.poll(height).toBeGreaterThan(0.6);

    await page.getByRole('button', { name: 'Wave 1: all settings' }).tap();
    const slider = page.getByRole('slider', { name: 'Wave 1 wavelength' });
    await slider.scrollIntoViewIfNeeded();
    const box = (await slider.boundingBox())!;
    await page.touchscreen.tap(box.x + box.width * 0.9, box.y + box.height / 2);
    expect((await state(page)).wind.waves[0]!.wavelength).toBeGreaterThan(45);

    // A pull on the handle, all the way up and down again.
    const grip = (await handle.boundingBox())!;
    await page.mouse.move(195, grip.y + 10);
    await page.mouse.down();
    await page.mouse.move(195, 60, { steps: 3 });
    await page.mouse.up();
    await expect.poll(height).toBeGreaterThan(0.85);
    await handle.press('ArrowDown');
    await handle.press('ArrowDown');
    await handle.press('ArrowDown');
    await expect.poll(height).toBeLessThan(0.12);

    // Nothing is wider than the window, and the middle of the tree is not covered.
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
    expect(await page.evaluate(() => document.elementFromPoint(195, 300)?.tagName)).toBe('CANVAS');
    expect(complaints).toEqual([]);
  });

  test('what can be touched is 44 pixels high, on every tab', async ({ page }) => {
    await open(page, BARE);
    await settled(page);
    await page.getByRole('button', { name: 'Got it' }).tap();
    for (const tab of ['Grow', 'Wind', 'Studio', 'Time', 'View']) {
      await page.getByRole('tab', { name: tab, exact: true }).tap();
      if (tab === 'Wind') await page.getByRole('button', { name: 'Wave 1: all settings' }).tap();
      // The plots come in a file of their own.
      if (tab === 'Studio') await expect(page.getByRole('button', { name: 'Download CSV' })).toBeVisible();
      const small = await page.evaluate(() =>
        [...document.querySelectorAll<HTMLElement>('button, input, summary, label.button, .dial')]
          .filter(
            (e) =>
              e.checkVisibility() && !e.closest('dialog, .spoken') && !e.matches('.spoken, .text, .handle, #scrub'),
          )
          .map((e) => (e.closest('label.toggle, .choice label, .wind') ?? e) as HTMLElement)
          .filter((e) => e.getBoundingClientRect().height < 44)
          .map((e) => e.outerHTML.slice(0, 80)),
      );
      expect(small, tab).toEqual([]);
    }
    expect(await faults(page)).toEqual([]);
  });
});
