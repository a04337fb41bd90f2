import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';
import { unzipSync } from 'fflate';
import { ALL_FORMATS, BufferSource, Input } from 'mediabunny';
import { BARE, inBothThemes, open, ready } from './editor-page.ts';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** A small tree that is written fast: two levels, no leaves. */
const SMALL = `${BARE}&tree.levels=2`;

const dialog = (page: Page) => page.getByRole('dialog', { name: 'Export' });

/** Opens the dialog with the keyboard alone. */
async function openDialog(page: Page): Promise<void> {
  await page.keyboard.press('Control+e');
  await expect(dialog(page)).toBeVisible();
  await expect(page.getByRole('radio', { name: '3D model GLB' })).toBeFocused();
}

/** Presses the button and reads the file that comes, by name and contents. */
async function take(page: Page, button: string): Promise<{ name: string; bytes: Uint8Array }> {
  const coming = page.waitForEvent('download');
  await page.getByRole('button', { name: button, exact: true }).click();
  const file = await coming;
  const bytes = new Uint8Array(await readFile(await file.path()));
  await expect(dialog(page).getByRole('status').filter({ hasText: 'is saved' })).toContainText(
    file.suggestedFilename(),
  );
  return { name: file.suggestedFilename(), bytes };
}

async function fill(page: Page, label: string, value: string): Promise<void> {
  const box = page.getByRole('spinbutton', { name: label, exact: true });
  await box.fill(value);
  await box.press('Tab');
}

/** Pixels of a PNG, by the browser. */
const pixels = (page: Page, bytes: Uint8Array) =>
  page.evaluate(
    async (data) => {
      const image = await createImageBitmap(new Blob([new Uint8Array(data)]));
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
      context.drawImage(image, 0, 0);
      const all = context.getImageData(0, 0, image.width, image.height).data;
      const colours = new Set(new Uint32Array(all.buffer)).size;
      let opaque = 0;
      for (let i = 3; i < all.length; i += 4) if (all[i] === 255) opaque++;
      return { width: image.width, height: image.height, corner: all[3], colours, opaque };
    },
    [...bytes],
  );

test('a model, by keyboard alone: magic, nodes and triangles as they were foretold', async ({ page }) => {
  const complaints = await open(page, SMALL);
  await openDialog(page);
  const foretold = dialog(page).locator('.export-figures');
  await expect(foretold).toContainText('triangles');
  const triangles = Number((await foretold.innerText()).split('triangles')[0]!.replace(/\D/g, ''));
  const coming = page.waitForEvent('download');
  await page.keyboard.press('Enter');
  const file = await coming;
  expect(file.suggestedFilename()).toBe('quaking-aspen-3.glb');
  const bytes = await readFile(await file.path());
  expect(bytes.subarray(0, 4).toString()).toBe('glTF');
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.subarray(20, 20 + length).toString()) as {
    nodes: unknown[];
    meshes: { primitives: { indices: number }[] }[];
    accessors: { count: number }[];
  };
  expect(json.nodes.length).toBeGreaterThan(0);
  const written = json.meshes
    .flatMap((mesh) => mesh.primitives)
    .reduce((sum, { indices }) => sum + json.accessors[indices]!.count / 3, 0);
  expect(Math.abs(triangles / written - 1)).toBeLessThan(0.06);
  await expect(page.getByRole('button', { name: 'Export GLB' })).toBeFocused();
  expect(complaints).toEqual([]);
});

test('skeleton, triangles as text, channels for an engine; what was chosen stays chosen', async ({ page }) => {
  await open(page, SMALL);
  await openDialog(page);
  await page.getByRole('radio', { name: 'Skeleton SWC' }).check();
  const swc = new TextDecoder().decode((await take(page, 'Export SWC')).bytes);
  const points = swc.split('\n').filter((line) => /^\d/.test(line));
  expect(points.length).toBeGreaterThan(60);
  expect(points[0]!.split(' ')).toHaveLength(7);

  await page.getByRole('radio', { name: '3D model, plain OBJ' }).check();
  await page.getByRole('combobox', { name: 'Textures' }).selectOption('128');
  const obj = unzipSync((await take(page, 'Export OBJ')).bytes);
  expect(Object.keys(obj).map((name) => name.split('.').at(-1))).toEqual(expect.arrayContaining(['obj', 'mtl', 'png']));
  expect(new TextDecoder().decode(obj[Object.keys(obj).find((name) => name.endsWith('.obj'))!])).toMatch(/^v /m);

  await page.getByRole('radio', { name: 'For game engines' }).check();
  await expect(page.getByRole('img', { name: 'The tree, coloured by the channel' })).toHaveAttribute(
    'data-channel',
    'sway',
  );
  await page.getByRole('radio', { name: 'Phase' }).check();
  await expect(page.getByRole('img', { name: 'The tree, coloured by the channel' })).toHaveAttribute(
    'data-channel',
    'phase',
  );
  await page.getByRole('combobox', { name: 'Channels for' }).selectOption('unreal');
  const channels = unzipSync((await take(page, 'Export for engines')).bytes);
  const endings = Object.keys(channels).map((name) => name.replace(/^quaking-aspen-3[-.]/, ''));
  expect(endings.sort()).toEqual(['axis.png', 'channels.txt', 'glb', 'pivot.exr']);

  await page.keyboard.press('Escape');
  await expect(dialog(page)).toBeHidden();
  await page.reload();
  await ready(page);
  await page.keyboard.press('Control+e');
  await expect(page.getByRole('radio', { name: 'For game engines' })).toBeChecked();
  await expect(page.getByRole('combobox', { name: 'Channels for' })).toHaveValue('unreal');
});

test('a picture of any size, transparent: the corner is clear and the tree is there; too large is refused with the most that can be', async ({
  page,
}) => {
  await open(page, BARE);
  await openDialog(page);
  await page.getByRole('radio', { name: 'Picture PNG' }).check();
  await fill(page, 'Width', '640');
  await fill(page, 'Height', '400');
  await page.getByRole('checkbox', { name: 'Transparent' }).check();
  const clear = await take(page, 'Export picture');
  expect(clear.name).toBe('quaking-aspen-3-640x400.png');
  const seen = await pixels(page, clear.bytes);
  expect(seen).toMatchObject({ width: 640, height: 400, corner: 0 });
  expect(seen.colours).toBeGreaterThan(50);
  expect(seen.opaque).toBeGreaterThan(100);
  await page.getByRole('checkbox', { name: 'Transparent' }).uncheck();
  const full = await pixels(page, (await take(page, 'Export picture')).bytes);
  expect(full).toMatchObject({ corner: 255, opaque: 640 * 400 });
  await fill(page, 'Width', '16384');
  await fill(page, 'Height', '16384');
  await page.getByRole('button', { name: 'Export picture' }).click();
  await expect(dialog(page).getByRole('status')).toContainText(/at most \d+ pixels/);
});

/** A film of a few small frames. */
async function shortFilm(page: Page, kind: string, frames: number): Promise<void> {
  await page.getByRole('radio', { name: kind }).check();
  await fill(page, 'Width', '160');
  await fill(page, 'Height', '120');
  await fill(page, 'Frames a second', '10');
  await fill(page, 'Length', String(frames / 10));
}

test('a sequence: one picture a frame, each another; cancelled: nothing is saved, and the next export works', async ({
  page,
}) => {
  await open(page, BARE);
  await openDialog(page);
  await shortFilm(page, 'Image sequence', 3);
  await expect(dialog(page).locator('.export-figures')).toContainText('3 frames');
  const { name, bytes } = await take(page, 'Export sequence');
  expect(name).toBe('quaking-aspen-3-160x120-frames.zip');
  const entries = unzipSync(bytes);
  const names = Object.keys(entries);
  expect(names).toEqual(['0001', '0002', '0003'].map((n) => `quaking-aspen-3-${n}.png`));
  expect(new Set(names.map((n) => Buffer.from(entries[n]!).toString('base64'))).size).toBe(3);
  expect((await pixels(page, entries[names[0]!]!)).width).toBe(160);

  await fill(page, 'Length', '100');
  let downloads = 0;
  page.on('download', () => downloads++);
  await page.getByRole('button', { name: 'Export sequence' }).click();
  await expect(dialog(page).getByRole('status')).toContainText(/Frame [1-9]\d* of 1000/);
  await expect(page.getByRole('button', { name: 'Cancel' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(dialog(page).getByRole('status')).toHaveText('Cancelled. Nothing was saved.');
  expect(downloads).toBe(0);
  await fill(page, 'Length', '0.1');
  await take(page, 'Export sequence');
});

test('a video where this browser encodes one, with every frame and its length; else words that say so', async ({
  page,
}) => {
  await open(page, BARE);
  const encodes = await page.evaluate(async () => {
    if (typeof VideoEncoder === 'undefined') return false;
    for (const codec of ['avc1.42001f', 'vp09.00.10.08', 'vp8', 'av01.0.04M.08']) {
      const { supported } = await VideoEncoder.isConfigSupported({ codec, width: 160, height: 120 });
      if (supported) return true;
    }
    return false;
  });
  test.info().annotations.push({ type: 'encoder', description: encodes ? 'a video was encoded' : 'none here' });
  await openDialog(page);
  await shortFilm(page, 'Video', 6);
  if (encodes) {
    const { name, bytes } = await take(page, 'Export video');
    expect(name).toMatch(/^quaking-aspen-3-160x120\.(mp4|webm)$/);
    const input = new Input({ formats: ALL_FORMATS, source: new BufferSource(bytes) });
    const track = (await input.getPrimaryVideoTrack())!;
    expect(await input.computeDuration()).toBeCloseTo(0.6, 2);
    expect((await track.computePacketStats()).packetCount).toBe(6);
  }
  // The words for a browser without an encoder, whatever this one has.
  await page.evaluate(() => Reflect.deleteProperty(window, 'VideoEncoder'));
  await page.getByRole('button', { name: 'Export video' }).click();
  await expect(dialog(page)).toContainText('This browser encodes no video.');
  await page.getByRole('button', { name: 'Take an image sequence instead' }).click();
  await expect(page.getByRole('radio', { name: 'Image sequence' })).toBeChecked();
});

test('axe finds nothing in both themes', async ({ page }) => {
  await open(page, SMALL);
  await page.addScriptTag({ path: axe });
  await openDialog(page);
  for (const kind of ['3D model GLB', 'For game engines', 'Video']) {
    await page.getByRole('radio', { name: kind }).check();
    await inBothThemes(page, async (theme) => {
      const faults = await page.evaluate(async () => {
        const { axe } = window as unknown as {
          axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
        };
        return (await axe.run()).violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ')}`);
      });
      expect(faults, `${kind}, ${theme}`).toEqual([]);
    });
  }
});
