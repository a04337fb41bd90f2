import { cpSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { type BrowserContext, expect, type Locator, type Page, test } from '@playwright/test';
import { decode } from 'fast-png';
import { build } from 'vite';
import { manifestOf, packed, project } from '../tests/lib/packed.ts';
import { serve } from './library/serve.ts';

// The npm package as others have it: packed, unpacked, built by their bundlers, opened in a browser. docs/library.md shows these projects.
const places: string[] = [];
const servers: (() => void)[] = [];

test.beforeAll(() => {
  // Kept from the unit tests where they ran before; else it is built here.
  test.setTimeout(300_000);
  packed();
});

test.afterAll(() => {
  for (const stop of servers) stop();
  for (const place of places) rmSync(place, { recursive: true, force: true });
});

/** A project of e2e/library with the package and `beside` installed. */
function made(from: string, beside: readonly string[]): string {
  const place = project(packed(), beside, from);
  places.push(place);
  return place;
}

async function bundled(root: string): Promise<string> {
  await build({ root, base: './', configFile: false, logLevel: 'error', build: { chunkSizeWarningLimit: 2000 } });
  return join(root, 'dist');
}

async function served(...args: Parameters<typeof serve>): Promise<string> {
  const { url, stop } = await serve(...args);
  servers.push(stop);
  return url;
}

/** How many colours a picture has, and which bytes it is. */
async function picture(what: Locator): Promise<{ colours: number; bytes: string }> {
  const png = await what.screenshot();
  const { data, channels } = decode(png);
  const colours = new Set<number>();
  for (let i = 0; i < data.length; i += channels) colours.add(data[i]! * 65536 + data[i + 1]! * 256 + data[i + 2]!);
  return { colours: colours.size, bytes: png.toString('base64') };
}

/** What the pages say from now on that is no good. */
function complaintsOf(page: Page): string[] {
  const said: string[] = [];
  page.removeAllListeners('pageerror');
  page.removeAllListeners('console');
  page.on('pageerror', (error) => said.push(error.message));
  page.on('console', (message) => {
    // Chromium's own remark on pictures of a canvas is no complaint of ours.
    if (['error', 'warning'].includes(message.type()) && !message.text().includes('ReadPixels'))
      said.push(message.text());
  });
  return said;
}

/** Opens a page, and sees a tree on it that moves; what the page complained of. */
async function seeATree(context: BrowserContext, url: string, where: string): Promise<string[]> {
  const page = await context.newPage();
  const said = complaintsOf(page);
  await page.goto(url);
  const what = page.locator(where);
  await expect.poll(async () => (await picture(what)).colours, { message: url }).toBeGreaterThan(250);
  const { bytes } = await picture(what);
  await expect.poll(async () => (await picture(what)).bytes, { message: url }).not.toBe(bytes);
  // It would go on drawing beside the next one.
  await page.close();
  return said;
}

test('the package, in a page, with Vite, and in React', async ({ context }) => {
  const vite = made('vite', ['three']);
  expect(await seeATree(context, await served(await bundled(vite)), 'canvas')).toEqual([]);

  const react = made('react', ['three', 'react', 'react-dom', '@react-three/fiber']);
  const said = await seeATree(context, await served(await bundled(react)), 'canvas');
  // React Three Fiber's own clock, which the newest three calls old.
  expect(said.filter((text) => !text.startsWith('THREE.Clock:'))).toEqual([]);

  const plain = made('page', []);
  cpSync(join(plain, 'node_modules/windgrove/dist-lib/windgrove.js'), join(plain, 'windgrove.js'));
  rmSync(join(plain, 'node_modules'), { recursive: true });
  expect(await seeATree(context, await served(plain), 'wind-tree')).toEqual([]);
});

test('the package with the newest three, and with the oldest that it takes, there without a worker', async ({
  page,
}) => {
  const place = made('versions', ['three', 'three-oldest']);
  const { three } = manifestOf(packed()).peerDependencies;
  const open = async (url: string): Promise<{ revision: number; colours: number; moved: number; said: string[] }> => {
    const said = complaintsOf(page);
    await page.goto(url);
    await expect(page).toHaveTitle(/pixels moved/);
    const [revision, colours, moved] = (await page.title()).match(/\d+/g)!.map(Number);
    return { revision: revision!, colours: colours!, moved: moved!, said };
  };

  const newest = await open(await served(place, (html) => html.replaceAll('THREE', 'three')));
  expect(newest.said).toEqual([]);
  expect(page.workers()).toHaveLength(1);

  const oldest = await open(
    await served(place, (html) => html.replaceAll('THREE', 'three-oldest'), {
      'content-security-policy': "worker-src 'none'",
    }),
  );
  expect(oldest.said.filter((text) => !/Content Security Policy/.test(text))).toEqual([]);
  expect(page.workers()).toHaveLength(0);

  expect(three).toBe(`>=0.${oldest.revision} <1`);
  expect(newest.revision).toBeGreaterThan(oldest.revision);
  for (const { colours, moved } of [newest, oldest]) {
    expect(colours).toBeGreaterThan(500);
    expect(moved).toBeGreaterThan(100);
  }
});
