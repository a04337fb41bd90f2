import { expect, type Page, test } from '@playwright/test';

// WindTree in a scene of somebody else's: e2e/pages/home.ts does the work and tells what it saw.
let complaints: string[] = [];

test.beforeEach(async ({ page }) => {
  complaints = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => {
    // Chromium's own remark on the read-back that these tests live on.
    if (['error', 'warning'].includes(message.type()) && !message.text().includes('ReadPixels'))
      complaints.push(message.text());
  });
  await page.goto('e2e/pages/home.html');
  await page.waitForFunction(() => 'home' in window);
});

test.afterEach(() => expect(complaints).toEqual([]));

type Home = Window['home'];
const ask = <K extends keyof Home>(page: Page, what: K): Promise<ReturnType<Home[K]>> =>
  page.evaluate((name) => window.home[name](), what) as Promise<ReturnType<Home[K]>>;

test('stands among directional, spot and point lights with shadows, in fog, with an environment map, clipped', async ({
  page,
}) => {
  const { colours, clipped } = await ask(page, 'everything');
  expect(colours).toBeGreaterThan(300);
  expect(clipped).toBeGreaterThan(0.003);
});

test('lights leaves at their corners as pixel by pixel, by one sun and the sky', async ({ page }) => {
  const { whole, near } = await ask(page, 'corners');
  for (const [{ changed, mean, reach }, most] of [
    [whole!, 7.3],
    [near!, 3.5],
  ] as const) {
    // Leaves are in the picture, two programs drew them, and nobody could tell: of 255, on the mean of what leaves cover.
    expect(reach).toBeGreaterThan(0.005);
    expect(changed).toBeGreaterThan(0);
    expect(mean / reach).toBeLessThan(most);
  }
});

test('its shadow sways with the wind and stands without', async ({ page }) => {
  const seen = await ask(page, 'shadows');
  expect(seen['wind against no shadow']).toBeGreaterThan(0.05);
  expect(seen['still against no shadow']).toBeGreaterThan(0.05);
  expect(seen.wind).toBeGreaterThan(0.005);
  expect(seen.still).toBe(0);
});

test('leans with the wind of the world however it is turned, and by when the wave reaches it', async ({ page }) => {
  const [plain, turned, downwind] = await ask(page, 'placement');
  // The gale blows to +x first of all.
  expect(plain[0]).toBeGreaterThan(0.02);
  expect(turned[0]).toBeGreaterThan(0.5 * plain[0]);
  expect(Math.hypot(downwind[0] - plain[0], downwind[1] - plain[1])).toBeGreaterThan(0.05 * plain[0]);
});

test('leaves nothing on the GPU when it goes', async ({ page }) => {
  await ask(page, 'memory'); // what three itself makes once and keeps
  const { before, during, after } = await ask(page, 'memory');
  for (let k = 0; k < 3; k++) expect(during[k]).toBeGreaterThan(before[k]!);
  expect(after).toEqual(before);
});

test('answers rays with the branch that they meet', async ({ page }) => {
  const { trunk, beside, crown } = await ask(page, 'rays');
  expect(trunk).toHaveLength(1);
  expect(trunk[0][0]).toBeGreaterThan(9.3);
  expect(trunk[0][0]).toBeLessThan(10);
  expect(trunk[0][1]).toBe(true);
  expect(beside).toEqual([]);
  expect(crown).toBe(1);
});

test('is not drawn behind the camera', async ({ page }) => {
  const { seen, behind } = await ask(page, 'culling');
  expect(seen).toBe(4);
  expect(behind).toBe(0);
});

test('draws fewer triangles from afar, and the levels and leaves that it is asked for', async ({ page }) => {
  const { far, near, trunk, few, bare, pieces, leaves } = await ask(page, 'detail');
  expect(near.triangles).toBeGreaterThan(3 * far.triangles);
  expect([near.pieces, near.leaves]).toEqual([pieces, leaves]);
  expect(trunk.pieces).toBeLessThan(10);
  expect(trunk.leaves).toBe(0);
  expect([few.pieces, few.leaves]).toEqual([pieces, 100]);
  expect([bare.pieces, bare.leaves]).toEqual([pieces, 0]);
});

test('shows its wireframe, its control polygons and its levels, and itself again', async ({ page }) => {
  const [wireframe, control, levels, shaded] = await ask(page, 'modes');
  for (const part of [wireframe, control, levels]) expect(part).toBeGreaterThan(0.01);
  expect(shaded).toBe(0);
});

test('shows a second wind on the same tree, with its shadow, as a tree of its own would', async ({ page }) => {
  const { apart, a, b, again, dropped } = await ask(page, 'compare');
  expect(apart).toBeGreaterThan(0.005);
  expect([a, b, again]).toEqual([0, 0, 0]);
  expect(dropped).toBeGreaterThanOrEqual(8);
});

test('has a still picture for browsers without WebGL2', async ({ page }) => {
  await page.goto('e2e/pages/still.html');
  await page.waitForFunction(() => 'done' in window);
  const seen = await page.evaluate(() => {
    const canvas = document.querySelector('canvas') as HTMLCanvasElement;
    const context = canvas.getContext('2d') as CanvasRenderingContext2D;
    const { width, height } = canvas;
    const { data } = context.getImageData(width * 0.4, height * 0.2, width * 0.2, height * 0.35);
    let green = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i + 1] > data[i] + 15 && data[i + 1] > data[i + 2] + 15) green++;
    return { green: green / (data.length / 4), colours: new Set(new Uint32Array(data.buffer)).size };
  });
  expect(seen.green).toBeGreaterThan(0.2);
  expect(seen.colours).toBeGreaterThan(100);
});
