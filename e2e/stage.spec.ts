import { createRequire } from 'node:module';
import { expect, test } from '@playwright/test';
import { address, BARE, difference, open, picture, settled } from './editor-page.ts';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

test('season, stage and hour change the picture and stand in the link', async ({ page }) => {
  const complaints = await open(page, BARE);
  const pictures = [await picture(page)];
  await page.getByRole('button', { name: 'Season, stage and light' }).click();
  const menu = page.locator('#scene-menu');
  const next = async (link: RegExp): Promise<void> => {
    await address(page, link);
    await settled(page);
    pictures.push(await picture(page));
  };
  await menu.getByRole('radio', { name: 'Golden hour' }).check();
  await next(/stage=golden/);
  await menu.getByLabel('Time of day').last().fill('06:30');
  await menu.getByLabel('Time of day').last().blur();
  await next(/hour=6\.5/);
  await menu.getByRole('checkbox', { name: 'As the stage has it' }).check();
  await expect(page).not.toHaveURL(/hour=/);
  await menu.getByRole('radio', { name: 'Autumn' }).check();
  await address(page, /season=autumn/);
  for (let i = 1; i < pictures.length; i++) {
    const { pixels } = await difference(page, pictures[i - 1]!, pictures[i]!);
    expect(pixels.length / 2).toBeGreaterThan(100_000);
  }
  // The same document gives the same picture again, whatever was chosen meanwhile.
  await menu.getByRole('radio', { name: 'Summer' }).check();
  await menu.getByRole('radio', { name: 'High' }).check();
  await menu.getByRole('radio', { name: 'Automatic' }).check();
  await settled(page);
  expect(await picture(page)).toBe(pictures[1]);
  expect(complaints).toEqual([]);
});

test('photo mode leaves the picture and a shutter, and gives the page back', async ({ page }) => {
  const complaints = await open(page, BARE);
  await expect(page.locator('wg-wind .field').first()).toBeVisible();
  await page.locator('.picture canvas').focus();
  await page.keyboard.press('v');
  await expect(page.getByRole('button', { name: 'Take the picture' })).toBeFocused();
  await expect(page.locator('.side, .bottom, .top').filter({ visible: true })).toHaveCount(0);
  await page.getByRole('radio', { name: '1 : 1' }).check();
  const frame = (await page.locator('.photo-frame').boundingBox())!;
  expect(Math.abs(frame.width - frame.height)).toBeLessThan(1);
  await page.addScriptTag({ path: axe });
  const faults = await page.evaluate(async () => {
    const { axe } = window as unknown as { axe: { run(): Promise<{ violations: { id: string }[] }> } };
    return (await axe.run()).violations.map((v) => v.id);
  });
  expect(faults).toEqual([]);
  // Exposure and lens show at once, and the page has them back as they were.
  const plain = await picture(page);
  for (const [name, value] of [
    ['Exposure', '-2'],
    ['Lens', '135'],
  ] as const) {
    await page.getByRole('spinbutton', { name }).fill(value);
    await page.getByRole('spinbutton', { name }).press('Enter');
  }
  await expect(page.getByRole('slider', { name: 'Lens' })).toHaveAttribute('aria-valuetext', '135 mm');
  await settled(page);
  const { pixels } = await difference(page, plain, await picture(page));
  expect(pixels.length / 2).toBeGreaterThan(100_000);
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Take the picture' }).click();
  expect((await download).suggestedFilename()).toMatch(/^quaking-aspen-3-1600x1600\.png$/);
  await page.keyboard.press('Escape');
  await expect(page.locator('wg-photo')).toHaveCount(0);
  await expect(page.locator('.picture canvas')).toBeFocused();
  await expect(page.locator('.side.grow')).toBeVisible();
  expect(complaints).toEqual([]);
});

test('a low sun draws the shadow of a far trunk as one line, though it is less wide than a pixel is long', async ({
  page,
}) => {
  await page.setViewportSize({ width: 1000, height: 640 });
  const trunk = 's=scots-pine&seed=1&t=2&paused=1&levels=1&leaves=0&stage=golden';
  await open(page, trunk);
  await settled(page);
  const [foot] = (await page.evaluate(() => window.windgrove!.onScreen())).branches;
  const shown = await picture(page);
  // Curves throw no shadow: what differs right of the trunk is its shadow.
  await page.getByRole('radio', { name: 'Curves' }).check();
  await settled(page);
  const { pixels } = await difference(page, shown, await picture(page), 6);
  const columns = new Set(pixels.filter((_, i) => i % 2 === 0));
  const first = Math.ceil(foot!) + 20;
  const gaps = Array.from({ length: 980 - first }, (_, i) => first + i).filter((x) => !columns.has(x));
  expect(gaps).toEqual([]);
});

test('grass answers a gale more than a breeze: it is not pressed flat, where no gust would move it', async ({
  page,
}) => {
  const moved = async (wind: string): Promise<number> => {
    await open(
      page,
      `seed=3&t=20&paused=1&levels=1&leaves=0&handle=0&fronts=0&hour=8.6&wind=${wind}&cam=20,6,7,0,0.3,0`,
    );
    await settled(page);
    const before = await picture(page);
    await page.evaluate(() => window.windgrove!.seek(20.4));
    await settled(page);
    const { pixels } = await difference(page, before, await picture(page), 8);
    return pixels.length / 2;
  };
  const breeze = await moved('breeze');
  expect(breeze).toBeGreaterThan(1000);
  expect(await moved('gale')).toBeGreaterThan(1.2 * breeze);
});
