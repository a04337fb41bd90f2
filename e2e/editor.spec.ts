import { readFileSync } from 'node:fs';
import { type Browser, expect, type Page, test } from '@playwright/test';
import { growPacked } from '../src/core/pack/grow-packed.ts';
import { POSE_TARGETS, TEXEL } from '../src/core/pack/layout.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import { WindFader } from '../src/core/wind/fade.ts';
import { poseTree } from '../src/core/wind/pose-tree.ts';
import { address, BARE, difference, open, picture, ready, settled, state, tips } from './editor-page.ts';

test.use({ viewport: { width: 800, height: 480 } });

/** Opens `link` in a window of its own and says in how many pixels its picture differs from `before`. */
async function again(browser: Browser, page: Page, before: string): Promise<{ other: Page; differing: number }> {
  const other = await browser.newPage({ viewport: page.viewportSize()! });
  await other.goto(page.url());
  await ready(other);
  await settled(other);
  const { pixels, colours } = await difference(page, before, await picture(other));
  expect(colours).toBeGreaterThan(100);
  return { other, differing: pixels.length };
}

test('the same link gives the same picture byte for byte, whatever was shown before', async ({ page, browser }) => {
  const complaints = await open(page, 'seed=3&t=2&paused=1&cam=30,8,40,0,5,0');
  // What came before must not matter.
  for (const steps of [1, -1]) {
    await page.evaluate((n) => window.windgrove!.step(n), steps);
    await settled(page);
  }
  await address(page, /t=2&.*w4=/);
  const { other, differing } = await again(browser, page, await picture(page));
  expect(differing).toBe(0);
  expect((await other.screenshot()).equals(await page.screenshot())).toBe(true);
  await other.close();
  expect(complaints).toEqual([]);
});

test('a camera that was moved is in the link, which gives the same picture', async ({ page, browser }) => {
  await open(page, 'seed=3&t=2&paused=1&levels=1');
  await settled(page);
  await page.mouse.move(400, 240);
  await page.mouse.down();
  await page.mouse.move(460, 220);
  await page.mouse.up();
  await settled(page);
  await page.locator('main canvas').press('ArrowLeft');
  await settled(page);
  await address(page, /cam=[\d.]+,[\d.-]+,[\d.]+,/);
  const camera = (await state(page)).camera;
  await expect.poll(() => page.url()).toContain(`cam=${camera!.azimuth},${camera!.elevation},${camera!.distance}`);
  const { other, differing } = await again(browser, page, await picture(page));
  expect(differing).toBe(0);
  expect((await state(other)).camera).toEqual(camera);
  await other.close();
});

test('half a second later the picture differs where the branches are and nowhere else in the sky', async ({ page }) => {
  await open(page, 'seed=3&t=2&paused=1&leaves=0&wind=fresh-breeze');
  await settled(page);
  const look = async () => ({
    shot: await picture(page),
    ...(await page.evaluate(() => window.windgrove!.onScreen())),
  });
  const before = await look();
  await page.evaluate(() => window.windgrove!.seek(2.5));
  await settled(page);
  const after = await look();
  const { pixels, colours } = await difference(page, before.shot, after.shot);
  expect(colours).toBeGreaterThan(100);

  const near = new Set<string>();
  const points = [...before.branches, ...after.branches];
  for (let i = 0; i < points.length; i += 2) {
    for (let dx = -3; dx <= 3; dx++) {
      for (let dy = -3; dy <= 3; dy++)
        near.add(`${Math.round(points[i]! / 4) + dx},${Math.round(points[i + 1]! / 4) + dy}`);
    }
  }
  let moved = 0;
  const stray: string[] = [];
  for (let i = 0; i < pixels.length; i += 2) {
    const [x, y] = [pixels[i]!, pixels[i + 1]!];
    if (y > Math.min(before.horizon, after.horizon) - 4) continue;
    moved++;
    if (!near.has(`${Math.round(x / 4)},${Math.round(y / 4)}`)) stray.push(`${x},${y}`);
  }
  expect(moved).toBeGreaterThan(200);
  expect(stray).toEqual([]);
});

test('a step of the clock moves the tips as the TypeScript twin says', async ({ page }) => {
  // The model without a memory: its twin needs no past.
  await open(page, `${BARE}&wind=gale&model=direct`);
  const { species } = parseSpecies(readFileSync('public/species/quaking-aspen.json', 'utf8'));
  const { packed } = growPacked(species!, 3);
  const twin = (wind: WindFader, time: number): Float32Array => {
    const pose = poseTree(packed, wind.at(time), 'exact');
    const plane = packed.restPose.width * packed.restPose.height * TEXEL;
    const found = new Float32Array(3 * packed.pieceCount);
    for (let i = 0; i < packed.pieceCount; i++) {
      const at = POSE_TARGETS.P3 * plane + TEXEL * i;
      found.set(pose.subarray(at, at + 3), 3 * i);
    }
    return found;
  };
  const distance = (a: ArrayLike<number>, b: ArrayLike<number>): number[] =>
    Array.from({ length: a.length / 3 }, (_, i) =>
      Math.hypot(a[3 * i]! - b[3 * i]!, a[3 * i + 1]! - b[3 * i + 1]!, a[3 * i + 2]! - b[3 * i + 2]!),
    );

  const wind = new WindFader((await state(page)).wind);
  await settled(page);
  const before = await tips(page);
  await page.getByRole('button', { name: 'Single step' }).click();
  await settled(page);
  const after = await tips(page);
  expect(before).toHaveLength(3 * packed.pieceCount);
  const time = (await state(page)).time;
  expect(time).toBe(121 / 60);
  expect(Math.max(...distance(before, twin(wind, 2)))).toBeLessThan(1e-4);
  expect(Math.max(...distance(after, twin(wind, time)))).toBeLessThan(1e-4);
  expect(Math.max(...distance(before, after))).toBeGreaterThan(1e-3);
});

test('play, pause, scrub and step do what they say', async ({ page }) => {
  await open(page, BARE);
  const time = () => page.evaluate(() => window.windgrove!.time());
  await page.getByRole('button', { name: 'Play' }).click();
  await expect.poll(time).toBeGreaterThan(2);
  await page.getByRole('button', { name: 'Pause' }).click();
  await settled(page);
  const stopped = await time();
  await settled(page);
  expect(await time()).toBe(stopped);
  expect(Math.abs(stopped * 60 - Math.round(stopped * 60))).toBeLessThan(1e-9);
  await address(page, new RegExp(`t=${Number(stopped.toFixed(4))}&paused=1`));

  const scrub = page.getByRole('slider', { name: 'Time', exact: true });
  await scrub.fill('20');
  expect(await time()).toBe(20);
  await expect(page.getByRole('spinbutton', { name: 'Time, seconds' })).toHaveValue('20.00');
  await scrub.press('ArrowRight');
  expect(await time()).toBe(20 + 1 / 60);
  await page.keyboard.press('Shift+ArrowLeft');
  expect(await time()).toBeCloseTo(19 + 1 / 60, 9);
  await page.locator('main canvas').focus();
  await page.keyboard.press('.');
  expect(await time()).toBeCloseTo(19 + 2 / 60, 9);
  await page.keyboard.press('Space');
  await expect.poll(time).toBeGreaterThan(19.1);
  expect((await state(page)).paused).toBe(false);
});

test('a wave is set with the keyboard: the wind changes, the link says so, nothing grows', async ({ page }) => {
  const complaints = await open(page, BARE);
  await settled(page);
  const before = await tips(page);
  await page.evaluate(() => {
    const grown = { count: 0 };
    Object.assign(window, { grown });
    new MutationObserver((changes) => {
      grown.count += changes.filter((c) => c.oldValue !== document.documentElement.dataset.ready).length;
    }).observe(document.documentElement, { attributeFilter: ['data-ready'], attributeOldValue: true });
  });
  const slider = page.getByRole('slider', { name: 'Wave 1 amplitude' });
  const from = (await state(page)).wind.waves[0]!.amplitude;
  await slider.focus();
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('ArrowRight');
  const to = (await state(page)).wind.waves[0]!.amplitude;
  expect(to - from).toBeCloseTo(0.055, 9);
  await expect(page.getByRole('spinbutton', { name: 'Wave 1 amplitude, metres', exact: true })).toHaveValue(
    to.toFixed(3),
  );
  await settled(page);
  expect(await tips(page)).not.toEqual(before);
  const link = await address(page, new RegExp(`w1=${to},`));
  expect(link.get('wind')).toBe('breeze');

  // The switch of a wave, and a number that is typed; one that cannot be is put back.
  await page.getByRole('checkbox', { name: 'Wave 2 on' }).press('Space');
  await page.getByRole('button', { name: 'Wave 3: all settings' }).click();
  await page.getByRole('spinbutton', { name: 'Wave 3 speed, metres a second' }).fill('7.25');
  await page.keyboard.press('Enter');
  const silly = page.getByRole('spinbutton', { name: 'Wave 3 wavelength, metres' });
  const good = await silly.inputValue();
  await silly.fill('-4');
  await page.keyboard.press('Enter');
  await expect(silly).toHaveValue(good);
  const { waves } = (await state(page)).wind;
  expect(waves[1]!.on).toBe(false);
  expect(waves[2]!.speed).toBe(7.25);
  await address(page, /w2=[^&]*,off/);
  await settled(page);
  expect(await page.evaluate(() => (window as unknown as { grown: { count: number } }).grown.count)).toBe(0);
  expect(complaints).toEqual([]);
});

test('another species, another seed, fewer levels: the tree follows, and so does the link', async ({ page }) => {
  const complaints = await open(page, `${BARE}&s=quaking-aspen`);
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Quaking Aspen');
  await page.getByRole('combobox', { name: 'Species', exact: true }).selectOption('Black Tupelo');
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Black Tupelo');
  await ready(page);
  const tupelo = await tips(page);
  await page.getByRole('button', { name: 'Another' }).click();
  await expect.poll(async () => (await state(page)).seed).not.toBe(3);
  await ready(page);
  expect(await tips(page)).not.toEqual(tupelo);
  await page.getByRole('radio', { name: 'Trunk' }).check();
  const link = await address(page, /levels=1/);
  expect(link.get('s')).toBe('black-tupelo');

  // Another link in the same page: the address is read again.
  await page.evaluate(() => {
    location.hash = 's=quaking-aspen&seed=5&paused=1&levels=2&leaves=0';
  });
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Quaking Aspen');
  await ready(page);
  expect(await state(page)).toMatchObject({ seed: 5, levelsShown: 2, showLeaves: false, time: 0 });
  expect(complaints).toEqual([]);
});
