import { expect, type Page, test } from '@playwright/test';
import type {} from '../src/forest/test-hook.ts';

// The page of the forest, small: what is tested is that it follows its reader.
test.use({ viewport: { width: 760, height: 320 }, contextOptions: { reducedMotion: 'reduce' } });

const SMALL = 'trees=1&size=100&gap=4&mix=quaking-aspen:1&hills=3,8,90,2,6,0,90&clear=1,0,50&cam=0,-60,12,90,-4';

const eye = (page: Page) => page.evaluate(() => window.windgroveForest!.camera());

test('a link makes its forest, what is wrong with it or with a picture is said, keys fly, and the address follows', async ({
  page,
}) => {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.goto(`forest.html#${SMALL}&season=monsoon`);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('season: found “monsoon”; allowed: spring, summer, autumn, winter.');
  await page.getByRole('button', { name: 'Close the message' }).click();
  // A forest without a name is none of the scenes.
  const scenes = page.getByRole('region', { name: 'Scenes' }).getByRole('button');
  await expect(scenes).toHaveCount(3);
  for (const scene of await scenes.all()) await expect(scene).toHaveAttribute('aria-pressed', 'false');
  expect(await page.evaluate(() => window.windgroveForest!.state().name)).toBe('Own forest');
  await page.getByText('Ground', { exact: true }).click();
  await page
    .locator('input[type=file]')
    .first()
    .setInputFiles({ name: 'hills.png', mimeType: 'image/png', buffer: Buffer.from('no picture') });
  await expect(alert).toContainText('hills.png');
  await page.keyboard.press('Escape');
  await expect(alert).toHaveCount(0);
  expect(await page.evaluate(() => window.windgroveForest!.state().terrain.kind)).toBe('hills');
  await page.locator('html[data-ready=true]').waitFor({ timeout: 60_000 });
  const stats = await page.evaluate(() => window.windgroveForest!.stats());
  expect(stats.trees).toBe(1);
  expect(stats.near + stats.middle + stats.far).toBeGreaterThan(0);

  const before = await eye(page);
  await page.locator('canvas').focus();
  await page.keyboard.down('w');
  await page.waitForFunction((y) => window.windgroveForest!.camera().y > y + 2, before.y);
  await page.keyboard.up('w');
  await page.waitForFunction(() => Number(/cam=[^,]*,(-?[\d.]+)/.exec(location.hash)?.[1]) > -58);
  await page.reload();
  // The eye stands where the link says as soon as there is ground under it.
  await page.waitForFunction(() => (window.windgroveForest?.camera().y ?? -60) > -58.5);
  expect(complaints).toEqual([]);
});
