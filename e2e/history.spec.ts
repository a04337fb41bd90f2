import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, type Locator, type Page, test } from '@playwright/test';
import { browserArgs } from './browser.mjs';
import { BARE, open, ready, settled, state } from './editor-page.ts';

test.use({ viewport: { width: 1024, height: 640 } });

const strength = (page: Page): Locator => page.getByRole('slider', { name: 'Wind strength' });

/** Drags the thumb of a slider over the middle half of it, in many small moves. */
async function drag(page: Page, slider: Locator): Promise<void> {
  const box = (await slider.boundingBox())!;
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width * 0.75, y);
  await page.mouse.down();
  for (let i = 0; i <= 10; i++) await page.mouse.move(box.x + box.width * (0.75 - i * 0.05), y);
  await page.mouse.up();
}

const steps = (page: Page): Promise<string[]> => page.locator('wg-history .step span').allTextContents();

/** Documents that the browser keeps, as their seeds and strengths of the wind. */
const kept = (page: Page): Promise<string[]> =>
  page.evaluate(
    () =>
      new Promise((done) => {
        const opening = indexedDB.open('windgrove');
        // Nothing was kept yet: the page is to make the store, not this question.
        let none = false;
        opening.onupgradeneeded = () => {
          none = true;
          opening.transaction!.abort();
        };
        opening.onerror = () => done(none ? [] : [`${opening.error}`]);
        opening.onsuccess = () => {
          const all = opening.result.transaction('work').objectStore('work').getAll();
          all.onsuccess = () => {
            opening.result.close();
            done(all.result.map(({ document: d }) => `${d.seed} ${d.wind.strength}`));
          };
        };
      }),
  );

test('a drag that goes on after an undo, or after another window had the focus, is one more step', async ({ page }) => {
  const complaints = await open(page, BARE);
  const to = async (part: number): Promise<void> => {
    const box = (await strength(page).boundingBox())!;
    await page.mouse.move(box.x + box.width * part, box.y + box.height / 2, { steps: 4 });
  };
  const interruptions = [
    () => page.keyboard.press('Control+z'),
    () => page.evaluate(() => void window.dispatchEvent(new Event('blur'))),
  ];
  for (const interrupt of interruptions) {
    await to(0.7);
    await page.mouse.down();
    await to(0.6);
    await interrupt();
    await to(0.4);
    await page.mouse.up();
  }
  // The first drag's beginning is undone and gone; the second drag is two steps.
  await page.keyboard.press('y');
  await expect(page.locator('wg-history .step')).toHaveCount(4);
  expect(complaints).toEqual([]);
});

test('a drag is one step; undo, redo and a click in the list go there and back', async ({ page }) => {
  const complaints = await open(page, BARE);
  const undo = page.getByRole('button', { name: /^Undo/ });
  await expect(page.getByRole('button', { name: /^Nothing to undo/ })).toBeDisabled();
  await drag(page, strength(page));
  const dragged = (await state(page)).wind.strength;
  expect(dragged).toBeGreaterThan(0.15);
  expect(dragged).toBeLessThan(0.35);
  await expect(undo).toHaveAccessibleName(new RegExp(`Strength of the wind ${dragged.toFixed(2)}`));

  await strength(page).focus();
  // Held down: the keyboard repeats it.
  for (let i = 0; i < 5; i++) await page.keyboard.down('ArrowRight');
  await page.keyboard.up('ArrowRight');
  await page.getByRole('radio', { name: 'Gale', exact: true }).check({ force: true });
  await page.keyboard.press('l');

  await page.keyboard.press('y');
  await expect(page.locator('wg-history .step')).toHaveCount(5);
  const [, , keys] = await steps(page);
  expect(await steps(page)).toEqual([
    'As it began',
    `Strength of the wind ${dragged.toFixed(2)}`,
    keys,
    'Wind: Gale',
    'Leaves on',
  ]);
  expect(keys).toMatch(/^Strength of the wind/);

  // Undo acts while the list is open, and the list follows.
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(page.locator('wg-history [aria-current="step"]')).toContainText(keys!);
  expect(await state(page)).toMatchObject({ showLeaves: false, preset: 'breeze' });
  await page.keyboard.press('Control+Shift+z');
  expect(await state(page)).toMatchObject({ showLeaves: false, preset: 'gale' });

  await page.getByRole('button', { name: 'As it began' }).click();
  expect(await state(page)).toMatchObject({ preset: 'breeze', wind: { strength: 1 } });
  // With the keys: two lines down.
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await expect(page.locator('wg-history [aria-current="step"]')).toContainText(keys!);
  await page.keyboard.press('Escape');
  await expect(page.locator('wg-history')).toBeHidden();
  expect(complaints).toEqual([]);
});

test('what is being typed stays, however often the page is drawn meanwhile', async ({ page }) => {
  await open(page, BARE);
  const seed = page.getByRole('spinbutton', { name: 'Seed' });
  await seed.fill('8');
  // Another time in the address: every panel is drawn again.
  await page.evaluate(() => location.replace(`${location.href.replace('&t=2', '&t=3')}`));
  await expect.poll(async () => (await state(page)).time).toBe(3);
  await expect(seed).toHaveValue('8');
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await state(page)).seed).toBe(8);
  await page.keyboard.press('ArrowUp');
  await expect(seed).toHaveValue('9');
  await page.keyboard.press('Control+z');
  await expect(seed).toHaveValue('8');
});

test('a snapshot is taken, renamed, shown, deleted and put back', async ({ page }) => {
  const complaints = await open(page, BARE);
  await page.keyboard.press('y');
  await page.getByRole('button', { name: 'Keep this as a snapshot' }).click();
  const name = page.getByRole('textbox', { name: 'Rename Quaking Aspen, no. 3' });
  await expect(name).toBeVisible();
  await expect(page.locator('.snapshot img')).toHaveAttribute('src', /^data:image\//);
  await name.fill('Calm and bare');
  await name.press('Enter');
  const shown = page.getByRole('button', { name: 'Show Calm and bare' });
  await expect(shown).toBeVisible();

  await page.keyboard.press('Escape');
  await page.keyboard.press('b');
  await page.keyboard.press('l');
  await page.keyboard.press('y');
  await shown.click();
  expect(await state(page)).toMatchObject({ blowing: true, showLeaves: false });
  await page.keyboard.press('Control+z');
  expect(await state(page)).toMatchObject({ blowing: false, showLeaves: true });

  await page.getByRole('button', { name: 'Delete Calm and bare' }).click();
  await expect(shown).toHaveCount(0);
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Put back' }).click();
  await page.keyboard.press('y');
  await expect(shown).toBeVisible();
  expect(complaints).toEqual([]);
});

test('what was made survives a crash and a closed browser, steps and all', async ({ playwright, baseURL }) => {
  const folder = mkdtempSync(join(tmpdir(), 'windgrove-'));
  const start = () =>
    playwright.chromium.launchPersistentContext(folder, {
      executablePath: process.env.WINDGROVE_BROWSER!,
      args: browserArgs,
      viewport: { width: 800, height: 480 },
      baseURL: baseURL!,
    });
  let context = await start();
  try {
    const page = await context.newPage();
    await page.goto(`./#${BARE}`);
    await ready(page);
    await page.keyboard.press('b');
    await page.getByRole('spinbutton', { name: 'Seed' }).fill('8');
    await page.keyboard.press('Enter');
    await ready(page);
    await expect.poll(() => kept(page)).toEqual(['8 1']);
    const crashed = page.waitForEvent('crash');
    const cdp = await context.newCDPSession(page);
    void cdp.send('Page.crash').catch(() => {});
    await crashed;

    const again = await context.newPage();
    await again.goto('./');
    await ready(again);
    await expect(again.getByText(/^Note: Your tree from .* is back/)).toBeVisible();
    expect(await state(again)).toMatchObject({ seed: 8, blowing: false, levelsShown: 2, paused: true, time: 2 });
    await again.keyboard.press('Control+z');
    await ready(again);
    expect(await state(again)).toMatchObject({ seed: 3, blowing: false });
    await expect.poll(() => kept(again)).toEqual(['3 1']);
    await context.close();

    context = await start();
    const later = await context.newPage();
    await later.goto('./');
    await ready(later);
    expect(await state(later)).toMatchObject({ seed: 3, blowing: false });
    await later.keyboard.press('Control+Shift+z');
    await expect.poll(async () => (await state(later)).seed).toBe(8);
    await later.keyboard.press('Control+z');
    await expect.poll(async () => (await state(later)).seed).toBe(3);
    await later.keyboard.press('Control+z');
    await expect.poll(async () => (await state(later)).blowing).toBe(true);
    expect((await state(later)).seed).toBe(3);
    // Another link wins, and the work is a snapshot.
    await expect.poll(() => kept(later)).toEqual(['3 1']);
    await later.close();
    const linked = await context.newPage();
    await linked.goto('./#seed=21&paused=1&levels=1&leaves=0');
    await ready(linked);
    expect((await state(linked)).seed).toBe(21);
    await linked.keyboard.press('y');
    await linked.getByRole('button', { name: 'Show Before the link' }).click();
    expect(await state(linked)).toMatchObject({ seed: 3, blowing: true });
  } finally {
    await context.close();
    rmSync(folder, { recursive: true, force: true });
  }
});

/** As in a browser that cannot write files in place. */
const withoutPickers = (page: Page) =>
  page.addInitScript(() => {
    Object.assign(window, { showSaveFilePicker: undefined, showOpenFilePicker: undefined });
  });

/** Lets a file of this text go over the page. */
async function drop(page: Page, name: string, text: string): Promise<void> {
  await page.evaluate(
    ([name, text]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text!], name!));
      const event = (type: string) => new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true });
      document.body.dispatchEvent(event('dragover'));
      document.body.dispatchEvent(event('drop'));
    },
    [name, text] as const,
  );
}

test('a project is saved, and opened again by the file chooser and by a drop', async ({ page }) => {
  await withoutPickers(page);
  // Playwright catches choosers from the first listener on, a moment after it is there.
  page.on('filechooser', () => {});
  const complaints = await open(page, BARE);
  await page.keyboard.press('b');
  await page.keyboard.press('k');
  const saving = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  const download = await saving;
  expect(download.suggestedFilename()).toBe('quaking-aspen.windgrove.json');
  const text = readFileSync((await download.path())!, 'utf8');
  expect(JSON.parse(text)).toMatchObject({
    format: 'windgrove-project',
    seed: 3,
    blowing: false,
    preset: 'quaking-aspen',
  });
  await expect(page).toHaveTitle('quaking-aspen · Windgrove');
  const saved = await state(page);

  await page.keyboard.press('b');
  await expect(page).toHaveTitle('• quaking-aspen · Windgrove');
  await page.keyboard.press('Control+z');
  await expect(page).toHaveTitle('quaking-aspen · Windgrove');

  await page.getByRole('button', { name: /^File/ }).click();
  await page.getByRole('button', { name: 'New tree' }).click();
  await expect(page).toHaveTitle('Quaking Aspen · Windgrove');
  expect(await state(page)).toMatchObject({ seed: 1, blowing: true });

  const choosing = page.waitForEvent('filechooser');
  await page.keyboard.press('Control+o');
  await (await choosing).setFiles({
    name: 'old.windgrove.json',
    mimeType: 'application/json',
    buffer: Buffer.from(text),
  });
  await expect(page).toHaveTitle('old · Windgrove');
  await ready(page);
  expect(await state(page)).toEqual(saved);
  await page.keyboard.press('Control+z');
  await expect(page).toHaveTitle('Quaking Aspen · Windgrove');
  expect(await state(page)).toMatchObject({ seed: 1, blowing: true });

  await drop(page, 'dropped.windgrove.json', text.replace('"seed": 3', '"seed": 4'));
  await expect(page).toHaveTitle('dropped · Windgrove');
  expect(await state(page)).toEqual({ ...saved, seed: 4 });
  await drop(page, 'bad.windgrove.json', text.replace('"seed": 3', '"seed": -3'));
  await expect(page.getByRole('alert')).toContainText('bad.windgrove.json was not opened');
  await expect(page.getByRole('alert')).toContainText('seed: found -3');
  expect((await state(page)).seed).toBe(4);
  expect(complaints).toEqual([]);
});

test('a file is saved in place where the browser can, and still after a reload', async ({ page }) => {
  await page.addInitScript(() => {
    // A file of the page's own file system: the same handle, without a dialog that nobody can answer here.
    const inPage = async () =>
      (await navigator.storage.getDirectory()).getFileHandle('mine.windgrove.json', { create: true });
    Object.assign(window, { showSaveFilePicker: inPage });
  });
  const seedInFile = () =>
    page.evaluate(async () => {
      const handle = await (await navigator.storage.getDirectory()).getFileHandle('mine.windgrove.json');
      return (JSON.parse(await (await handle.getFile()).text()) as { seed: number }).seed;
    });
  await open(page, BARE);
  await page.keyboard.press('Control+s');
  await expect(page).toHaveTitle('mine · Windgrove');
  expect(await seedInFile()).toBe(3);
  const seed = page.getByRole('spinbutton', { name: 'Seed' });
  await seed.fill('5');
  await seed.press('Enter');
  await expect(page).toHaveTitle('• mine · Windgrove');
  await ready(page);
  await expect.poll(() => kept(page)).toEqual(['5 1']);
  await page.reload();
  await ready(page);
  await expect(page).toHaveTitle('• mine · Windgrove');
  await page.keyboard.press('Control+s');
  await expect(page).toHaveTitle('mine · Windgrove');
  expect(await seedInFile()).toBe(5);
});

test('the snippet shows the tree in another page, without panels, and keeps nothing', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page, BARE);
  await page.getByRole('button', { name: /^Share/ }).click();
  await page.getByRole('button', { name: /snippet/ }).click();
  await expect(page.getByRole('alert')).toContainText('The snippet is copied');
  const snippet = await page.evaluate(() => navigator.clipboard.readText());
  expect(snippet).toMatch(
    /^<iframe src="[^"<>]*viewer\.html#s=[^"<>]*" title="Quaking Aspen, a tree in the wind" [^<>]*><\/iframe>$/,
  );
  const other = await context.newPage();
  await other.setContent(snippet);
  const frame = other.frameLocator('iframe');
  await expect(frame.locator('html')).toHaveAttribute('data-ready', 'true', { timeout: 60_000 });
  await expect(frame.locator('wind-tree')).toHaveCount(1);
  await expect(frame.locator('canvas').first()).toBeVisible();
  await settled(page);
});
