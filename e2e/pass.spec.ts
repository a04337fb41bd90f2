import { expect, type Page, test } from '@playwright/test';
import { BARE, open, picture, settled, tips } from './editor-page.ts';

test.use({ viewport: { width: 640, height: 400 } });

/** The aspen's branches in a wind that has moved them, time standing still. */
const LINK = `${BARE}&wind=fresh-breeze`;

/** Loses the context of the picture and gives it back, as a driver that was reset does. */
const loseContext = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const canvas = document.querySelector('canvas')!;
    const extension = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    const event = (name: string) =>
      new Promise<void>((resolve) => canvas.addEventListener(name, () => setTimeout(resolve), { once: true }));
    const lost = event('webglcontextlost');
    extension.loseContext();
    await lost;
    const restored = event('webglcontextrestored');
    extension.restoreContext();
    await restored;
  });

test('after a lost and restored context the branches stand where they stood and look as they did', async ({ page }) => {
  const complaints = await open(page, LINK);
  await settled(page);
  const before = { tips: await tips(page), picture: await picture(page) };
  await loseContext(page);
  await settled(page);
  expect(await tips(page)).toEqual(before.tips);
  expect(await picture(page)).toBe(before.picture);
  expect(complaints).toEqual([]);
});

test('without float targets the CPU poses the same tree', async ({ page, browser }) => {
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
  await open(other, LINK);
  await settled(other);
  const cpu = await tips(other);
  expect(cpu.length).toBe(gpu.length);
  // The tree is some 13 m high: 2e-5 of it.
  expect(Math.max(...cpu.map((value, i) => Math.abs(value - gpu[i])))).toBeLessThan(2.6e-4);

  // And time moves them.
  await other.evaluate(() => window.windgrove!.seek(5));
  await settled(other);
  const later = await tips(other);
  expect(Math.max(...later.map((value, i) => Math.abs(value - cpu[i])))).toBeGreaterThan(0.01);
  await other.close();
});

test('the lagged pose is the same however its time was reached', async ({ page }) => {
  await open(page, `${LINK}&pose=lagged`);
  await settled(page);
  await page.evaluate(() => window.windgrove!.step(30));
  await settled(page);
  const stepped = await tips(page);
  await page.evaluate(() => window.windgrove!.seek(40));
  await settled(page);
  await page.evaluate(() => window.windgrove!.seek(2.5));
  await settled(page);
  expect(await tips(page)).toEqual(stepped);
});
