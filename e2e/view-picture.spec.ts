import { expect, test } from '@playwright/test';

// The picture of the editor by itself: e2e/pages/view-picture.ts.
test.beforeEach(async ({ page }) => {
  await page.goto('e2e/pages/view-picture.html');
  await page.waitForFunction(() => 'scene' in window);
});

test('shows the wind, its handle, a probe and a branch, each when it is asked for', async ({ page }) => {
  const seen = await page.evaluate(() => window.scene.overlays());
  for (const part of [seen.arrows, seen.handle, seen.front]) expect(part).toBeGreaterThan(0.004);
  for (const part of [seen.probe, seen.highlight]) expect(part).toBeGreaterThan(0.0003);
  // No gust blows: there is no front; and nothing is left of what was taken away.
  expect([seen.fronts, seen.none]).toEqual([0, 0]);
});

test('sticks the probe to the end of its branch in the wind', async ({ page }) => {
  const { near, without } = await page.evaluate(() => window.scene.probe());
  expect(near).toBeLessThan(40);
  expect(without).toBeGreaterThan(60);
});

test('shows A left and B right of the line as each is alone, and only A when the line goes', async ({ page }) => {
  const { apart, left, right, side, again, calls } = await page.evaluate(() => window.scene.split());
  expect(apart).toBeGreaterThan(0.02);
  expect([left, right, again]).toEqual([0, 0, 0]);
  expect(side).toBeGreaterThan(0.02);
  expect(calls).toBeGreaterThan(1.5);
});

test('lets its handle be dragged while the camera keeps still, and tells the wind', async ({ page }) => {
  const camera = await page.evaluate(() => window.scene.handle());
  // The wind blows to +x, as hard as it can: the knob is left of the tree.
  const { x, y, height } = await page.evaluate(() => window.scene.find('grab'));
  expect(height).toBeGreaterThan(8);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 18, y + 14, { steps: 3 });
  await page.mouse.up();
  const told = await page.evaluate(() => window.scene.told);
  expect(told.map((words) => (words as unknown[])[0])).toEqual(['handle', 'handle', 'handle', 'handle']);
  const [, direction, strength, done] = told.at(-1) as [string, number, number, boolean];
  expect(done).toBe(true);
  expect(direction).toBeGreaterThan(0.2);
  expect(direction).toBeLessThan(1.5);
  expect(strength).toBeGreaterThan(0.1);
  expect(strength).toBeLessThan(0.95);
  expect(await page.evaluate(() => window.scene.handle())).toEqual(camera);
});

test('lets the line between A and B be dragged, and then a click is a click again', async ({ page }) => {
  const camera = await page.evaluate(() => window.scene.line());
  const { x } = await page.evaluate(() => window.scene.find('ew-resize'));
  await page.mouse.move(x, 300);
  await page.mouse.down();
  await page.mouse.move(x + 48, 320, { steps: 2 });
  await page.mouse.up();
  const told = (await page.evaluate(() => window.scene.told)) as [string, number, boolean][];
  expect(told.map(([name]) => name)).toEqual(['wipe', 'wipe', 'wipe']);
  expect(told[2]?.[1]).toBeCloseTo(0.4, 2);
  expect(told.map(([, , done]) => done)).toEqual([false, false, true]);
  expect(await page.evaluate(() => window.scene.line())).toEqual(camera);
});

test('tells which branch was clicked, and where on the meadow', async ({ page }) => {
  const { trunk } = await page.evaluate(() => window.scene.points());
  const [x, y] = trunk as [number, number];
  await page.mouse.click(x, y);
  await page.mouse.click(420, 360);
  const told = (await page.evaluate(() => window.scene.told)) as [string, number | null, number | null][];
  const clicks = told.filter(([name]) => name !== 'hover');
  // The trunk and its first piece; the meadow, which is no stem; and where on it.
  expect(clicks.slice(0, 2)).toEqual([
    ['stem', 0, 0],
    ['stem', null, null],
  ]);
  expect(clicks.slice(2).map(([name]) => name)).toEqual(['throw']);
  // Before the tree, and right of it.
  expect(clicks[2]?.[1]).toBeGreaterThan(1);
  expect(clicks[2]?.[2]).toBeLessThan(-1);
  expect(await page.evaluate(() => [window.scene.pick(60, 40), window.scene.ground(60, 40)])).toEqual([null, null]);
});

test('reads its state textures and a single piece back', async ({ page }) => {
  const { size, pieceCount, layers, texel, piece, none } = await page.evaluate(() => window.scene.read());
  expect(layers).toEqual(['P0', 'P1', 'P2', 'P3', 'Q', 'BASE', 'END'].map((id) => [id, size]));
  expect(size).toBeGreaterThanOrEqual(4 * pieceCount);
  expect(piece).toHaveLength(16);
  expect(texel).toEqual(piece);
  expect(none).toBeNull();
});
