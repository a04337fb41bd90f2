import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { forceOfSpeed } from '../src/core/wind/speed.ts';
import { address, BARE, difference, open, picture, settled, state, tips } from './editor-page.ts';

test.use({ viewport: { width: 1280, height: 800 } });

const wave = (page: Page, n: number) => page.getByRole('region', { name: `Wave ${n}`, exact: true });

test('the mixer: solo, dial, metres a second, add, move with keys, remove; the link holds it all', async ({ page }) => {
  const complaints = await open(page, BARE);
  const before = (await state(page)).wind.waves.map((w) => w.amplitude);
  const ten = Number(forceOfSpeed(10).toFixed(4));
  await wave(page, 2).getByRole('button', { name: 'Wave 2 solo' }).click();
  await expect(wave(page, 2).getByRole('button', { name: 'Wave 2 solo' })).toHaveAttribute('aria-pressed', 'true');

  // The dial by keys, and pulled straight down: away from you is up, so down is 270°.
  const dial = page.getByRole('slider', { name: 'Wave 1 direction, dial' });
  await dial.focus();
  await page.keyboard.press('Shift+ArrowRight');
  await expect(dial).toHaveAttribute('aria-valuenow', '25');
  const face = (await dial.boundingBox())!;
  await page.mouse.move(face.x + face.width - 2, face.y + face.height / 2);
  await page.mouse.down();
  await page.mouse.move(face.x + face.width / 2, face.y + 80, { steps: 4 });
  await page.mouse.up();
  await expect(dial).toHaveAttribute('aria-valuenow', '270');

  const speed = page.getByRole('spinbutton', { name: 'Wave 1 amplitude, metres a second' });
  await speed.fill('10');
  await speed.press('Enter');
  await expect(page.getByRole('spinbutton', { name: 'Wave 1 amplitude, metres', exact: true })).toHaveValue(
    ten.toFixed(3),
  );

  await page.getByRole('button', { name: 'Add a wave' }).click();
  await expect(page.getByRole('slider', { name: 'Wave 5 amplitude' })).toBeFocused();
  const grip = page.getByRole('button', { name: 'Place of wave 1' });
  await grip.focus();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('button', { name: 'Place of wave 2' })).toBeFocused();
  expect((await state(page)).wind.waves.map((w) => w.amplitude)).toEqual([before[1], ten, ...before.slice(2), 0.05]);
  await page.getByRole('button', { name: 'Remove wave 5' }).click();

  const { wind } = await state(page);
  expect(wind.waves.map((w) => w.solo)).toEqual([true, false, false, false]);
  await address(page, new RegExp(`w1=[^&]*,solo.*w2=${ten},270,.*w4=[^&]*&model`));
  expect(complaints).toEqual([]);
});

test('a row is pulled to another place, and Escape leaves it where it was', async ({ page }) => {
  await open(page, BARE);
  const lengths = async () => (await state(page)).wind.waves.map((w) => w.wavelength);
  const before = await lengths();
  const pull = async () => {
    const grip = (await page.getByRole('button', { name: 'Place of wave 1' }).boundingBox())!;
    const third = (await wave(page, 3).boundingBox())!;
    await page.mouse.move(grip.x + 5, grip.y + 10);
    await page.mouse.down();
    await page.mouse.move(third.x + 20, third.y + 20, { steps: 4 });
  };
  await pull();
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect(await lengths()).toEqual(before);
  await pull();
  await page.mouse.up();
  expect(await lengths()).toEqual([before[1], before[2], before[0], before[3]]);
});

test('a wind is dropped as a file, chosen, said to the wizard, copied and pasted; a bad file or paste changes nothing', async ({
  page,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const complaints = await open(page, BARE);
  const drop = (name: string, text: string): Promise<void> =>
    page.evaluate(
      ([name, text]) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([text!], name!));
        window.dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
      },
      [name, text],
    );
  const storm = readFileSync('public/winds/storm.json', 'utf8');
  await drop('my-storm.json', storm.replace('"Storm"', '"<b>My storm</b>"'));
  await expect.poll(async () => (await state(page)).preset).toBe('own');
  await expect(page.getByText('<b>My storm</b>', { exact: true })).toBeVisible();
  await drop('bad.json', storm.replace('"waves"', '"wavs"'));
  await expect(page.getByRole('alert')).toContainText('bad.json was not opened');
  expect((await state(page)).wind.name).toBe('<b>My storm</b>');
  await drop('mast.csv', readFileSync('public/winds/kaimal-sample.csv', 'utf8'));
  await expect.poll(async () => (await state(page)).wind.record?.name).toBe('mast.csv');

  await page.getByRole('radio', { name: 'Gale', exact: true }).check();
  expect((await state(page)).preset).toBe('gale');
  await page.getByText('Wizard', { exact: true }).click();
  await page.getByRole('slider', { name: 'Wizard Beaufort number' }).fill('9');
  await expect(page.locator('wg-wizard').getByText('Strong gale', { exact: true })).toBeVisible();
  const made = (await state(page)).wind;
  expect(made).toMatchObject({ name: 'Beaufort 9', model: 'spring' });
  await address(page, /wind=own&name=Beaufort%209/);

  await page.getByText('Copy, paste, files').click();
  await page.getByRole('button', { name: 'Copy wind' }).click();
  await expect(page.getByText('The wind is copied as JSON')).toBeVisible();
  await page.getByRole('radio', { name: 'Still', exact: true }).check();
  const box = page.getByRole('textbox', { name: 'Paste a wind here' });
  await box.focus();
  await page.keyboard.press('Control+v');
  await expect.poll(async () => (await state(page)).wind).toEqual(made);

  await box.fill('{"format":"windgrove-wind","version":1,"name":"x","waves":[{"amplitude":-1}]}');
  await box.press('Tab');
  await expect(page.getByRole('alert')).toContainText('What was pasted is no wind; yours still blows');
  await expect(page.getByRole('alert')).toContainText('waves[0].amplitude');
  expect((await state(page)).wind).toEqual(made);
  expect(complaints).toEqual([]);
});

test('the handle in the scene turns all waves together, and its strength is the factor', async ({ page }) => {
  await open(page, `${BARE}&cam=0,35,40,0,4,0`);
  await settled(page);
  const before = (await state(page)).wind;
  // The handle lies upwind of the foot of the tree, on the ground: the cursor tells when it is under the mouse.
  const [x, y] = (await page.evaluate(() => window.windgrove!.onScreen())).branches as [number, number];
  const cursor = () => page.evaluate(() => document.querySelector('canvas')!.style.cursor);
  let left = 0;
  while ((await cursor()) !== 'grab') {
    left += 10;
    expect(left).toBeLessThan(400);
    await page.mouse.move(x - left, y);
  }
  await page.mouse.down();
  await page.mouse.move(x - left + 20, y + 90, { steps: 4 });
  await page.mouse.up();
  const { wind } = await state(page);
  const turned = wind.waves.map((w, i) => Math.cos(w.direction - before.waves[i]!.direction));
  expect(turned[0]).toBeLessThan(0.999);
  for (const cos of turned) expect(cos).toBeCloseTo(turned[0]!, 2);
  await expect(page.getByText('Drag the wind.')).toBeHidden();
});

test('a gust is thrown by key and by click, stands on the ruler, is moved and taken away there', async ({ page }) => {
  const complaints = await open(page, `${BARE}&cam=0,35,40,0,4,0`);
  await page.locator('main canvas').focus();
  await page.keyboard.press('g');
  const mark = page.getByRole('button', { name: /^Gust 1, .* Delete removes it/ });
  await expect(mark).toHaveAttribute('aria-label', /at 2\.0 seconds/);
  expect((await state(page)).wind.gusts[0]!.start).toBe(2);
  await mark.press('ArrowRight');
  expect((await state(page)).wind.gusts[0]!.start).toBeCloseTo(2.1, 9);
  await mark.press('Delete');
  expect((await state(page)).wind.gusts).toEqual([]);

  await page.keyboard.press('t');
  await expect(page.getByText('Click the ground to throw a gust.')).toBeVisible();
  await page.mouse.click(760, 560);
  await expect.poll(async () => (await state(page)).wind.gusts.length).toBe(1);
  const [gust] = (await state(page)).wind.gusts;
  expect(Math.hypot(gust!.x, gust!.y)).toBeGreaterThan(1);
  await page.keyboard.press('Escape');
  await expect(page.getByText('Click the ground to throw a gust.')).toBeHidden();
  await page.mouse.click(740, 570);
  await settled(page);
  expect((await state(page)).wind.gusts).toHaveLength(1);
  await address(page, /g1=2,/);
  expect(complaints).toEqual([]);
});

test('a gust is seen crossing the meadow', async ({ page }) => {
  await open(page, `${BARE}&handle=0&cam=0,35,40,0,4,0`);
  await page.locator('main canvas').focus();
  await page.keyboard.press('g');
  await page.evaluate(() => window.windgrove!.seek(3.6));
  await settled(page);
  const seen = await picture(page);
  await page.getByRole('checkbox', { name: 'Fronts' }).uncheck();
  await settled(page);
  const { pixels } = await difference(page, seen, await picture(page));
  expect(pixels.length / 2).toBeGreaterThan(20_000);
});

test('a tree that remembers is the same at the same time, however the ruler was pulled', async ({ page }) => {
  await open(page, 'seed=3&t=6&paused=1&levels=2&leaves=0&wind=gusty-afternoon');
  await settled(page);
  expect((await state(page)).wind.model).toBe('spring');
  const before = await tips(page);
  const scrub = page.getByRole('slider', { name: 'Time', exact: true });
  for (const time of ['12', '3', '0', '9', '6']) await scrub.fill(time);
  await settled(page);
  expect(await tips(page)).toEqual(before);
  await page.getByRole('button', { name: 'Step back' }).click();
  await page.getByRole('button', { name: 'Single step' }).click();
  await settled(page);
  expect(await tips(page)).toEqual(before);
});

test('the wind is made to come around: the picture is the same a loop later', async ({ page }) => {
  await open(page, `${BARE}&model=direct`);
  await page.getByRole('button', { name: 'Loop', exact: true }).click();
  await page.getByRole('spinbutton', { name: 'Make it loop every' }).fill('4');
  await page.getByRole('button', { name: 'Make loop' }).click();
  await expect(page.getByText('Done: no wave became more than')).toBeVisible();
  await page.keyboard.press('Escape');
  const at = async (time: number) => {
    await page.evaluate((t) => window.windgrove!.seek(t), time);
    await settled(page);
    return tips(page);
  };
  const far = (a: number[], b: number[]) => Math.max(...a.map((x, i) => Math.abs(x - b[i]!)));
  const [now, half, later] = [await at(2), await at(4), await at(6)];
  expect(far(now, half)).toBeGreaterThan(1e-3);
  expect(far(now, later)).toBeLessThan(1e-4);
});

test('two winds on one tree: B is changed alone, the line is moved with keys', async ({ page }) => {
  const complaints = await open(page, `${BARE}&compare=split,0.5`);
  await settled(page);
  const before = await picture(page);
  await page.getByRole('radio', { name: 'Wind B' }).check();
  await page.getByRole('radio', { name: 'Storm', exact: true }).check();
  const { wind, compare } = await state(page);
  expect(wind.name).toBe('Breeze');
  expect(compare!.wind.name).toBe('Storm');
  await settled(page);
  const { pixels } = await difference(page, before, await picture(page));
  const xs = pixels.filter((_, i) => i % 2 === 0);
  expect(xs.length).toBeGreaterThan(50);
  expect(xs.reduce((a, x) => Math.min(a, x))).toBeGreaterThanOrEqual(640);
  const line = page.getByRole('slider', { name: 'Line between A and B' });
  await line.press('Shift+ArrowLeft');
  expect((await state(page)).compare!.at).toBeCloseTo(0.4, 9);
  await address(page, /compare=split,0\.4.*b\.wind=storm/);
  expect(complaints).toEqual([]);
});
