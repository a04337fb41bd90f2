import { expect, test } from '@playwright/test';
import { address, BARE, difference, open, picture, ready, settled, tips } from './editor-page.ts';

test.use({ viewport: { width: 640, height: 400 } });

/** The aspen's branches in a wind that has moved them, time standing still. */
const LINK = `${BARE}&wind=fresh-breeze`;

test('a lost graphics card is told of; after it the branches stand where they stood and look as they did', async ({
  page,
}) => {
  const complaints = await open(page, LINK);
  await settled(page);
  const before = { tips: await tips(page), picture: await picture(page) };
  // As a driver that was reset does.
  await page.evaluate(() => {
    const card = document.querySelector('canvas')!.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    Object.assign(window, { card });
    card.loseContext();
  });
  await expect(page.getByRole('alert')).toContainText('The graphics card was taken away');
  await page.evaluate(() => (window as unknown as { card: WEBGL_lose_context }).card.restoreContext());
  await expect(page.getByRole('alert')).toHaveText('');
  await settled(page);
  expect(await tips(page)).toEqual(before.tips);
  expect(await picture(page)).toBe(before.picture);
  expect(complaints).toEqual([]);
});

test('without float targets the CPU poses and draws the same tree, and a message says so', async ({
  page,
  browser,
}) => {
  await open(page, LINK);
  await settled(page);
  const gpu = await tips(page);

  const other = await browser.newPage({ viewport: page.viewportSize()! });
  await other.addInitScript(() => {
    const gl = WebGL2RenderingContext.prototype;
    const original = gl.getExtension as (name: string) => unknown;
    gl.getExtension = function (this: WebGL2RenderingContext, name: string) {
      return name === 'EXT_color_buffer_float' ? null : original.call(this, name);
    } as typeof gl.getExtension;
  });
  const complaints = await open(other, LINK);
  await expect(other.getByRole('alert')).toContainText('32-bit float textures; the wind is computed on the CPU');
  await settled(other);
  const before = await picture(other);
  const cpu = await tips(other);
  expect(cpu.length).toBe(gpu.length);
  // The tree is some 13 m high: 2e-5 of it.
  expect(Math.max(...cpu.map((value, i) => Math.abs(value - gpu[i])))).toBeLessThan(2.6e-4);

  // And time moves them.
  await other.evaluate(() => window.windgrove!.seek(5));
  await settled(other);
  const later = await tips(other);
  expect(Math.max(...later.map((value, i) => Math.abs(value - cpu[i])))).toBeGreaterThan(0.01);
  expect((await difference(other, before, await picture(other))).pixels.length).toBeGreaterThan(100);
  expect(complaints).toEqual([]);
  await other.close();
});

for (const pose of ['exact', 'lagged']) {
  test(`springs stand the same however their time was reached, ${pose}`, async ({ page }) => {
    await open(page, `${LINK}&model=spring&pose=${pose}`);
    await settled(page);
    await page.evaluate(() => window.windgrove!.step(30));
    await settled(page);
    const stepped = await tips(page);
    // Far enough to be caught up with over some frames.
    await page.evaluate(() => window.windgrove!.seek(40));
    await settled(page);
    const far = await tips(page);
    await page.evaluate(() => window.windgrove!.seek(2.5));
    await settled(page);
    expect(await tips(page)).toEqual(stepped);
    expect(far).not.toEqual(stepped);
  });
}

test('a page that played springs, was edited and given a gust, and rests, shows what its link shows', async ({
  page,
  browser,
}) => {
  // With its handle, which glows where it was just found, and is of the interface.
  const complaints = await open(page, 'seed=3&t=60&paused=1&levels=2&leaves=0&wind=fresh-breeze&model=spring');
  const played = (to: number) => page.waitForFunction((time) => window.windgrove!.time() > time, to);
  await page.keyboard.press('Space');
  await played(60.3);
  await page.keyboard.press('b');
  await played(60.6);
  await page.keyboard.press('b');
  await played(61.9);
  await page.keyboard.press('g');
  await played(63.5);
  await page.keyboard.press('Space');
  await settled(page);
  await address(page, /paused=1.*g1=/);
  const seen = { tips: await tips(page), picture: await picture(page) };
  const other = await browser.newPage({ viewport: page.viewportSize()! });
  await other.goto(page.url());
  await ready(other);
  await settled(other);
  expect(await tips(other)).toEqual(seen.tips);
  expect((await difference(page, seen.picture, await picture(other))).pixels).toEqual([]);
  await other.close();
  expect(complaints).toEqual([]);
});
