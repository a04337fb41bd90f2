import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { DEFAULT_EXPORT } from '../src/core/io/export-options.ts';
import { exportTree } from '../src/core/io/export-tree.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import type { Species } from '../src/core/species/species.ts';
import { parseWind } from '../src/core/wind/parse-wind.ts';
import type { Answer, Asked, ExportPage } from './pages/export-glb.ts';

type Window = { windgroveExport: ExportPage };

const read = <T>(value: T | undefined): T => {
  if (!value) throw new Error('the file has faults');
  return value;
};

/** A species with a few branches: software GL draws it at once. */
const aspen: Species = (() => {
  const species = read(parseSpecies(readFileSync('public/species/quaking-aspen.json', 'utf8')).species);
  const levels = species.levels.map((level, i) => ({ ...level, branches: [1, 14, 8, 0][i] ?? 0 }));
  return { ...species, levels };
})();
const wind = read(parseWind(readFileSync('public/winds/strong-breeze.json', 'utf8')).wind);

async function open(page: Page): Promise<void> {
  await page.goto('e2e/pages/export-glb.html');
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
}

const answer = (page: Page, asked: Asked): Promise<Answer> =>
  page.evaluate((a) => (window as unknown as Window).windgroveExport.exported(a), asked);

test('the worker of a browser writes the same GLB as Node, and three draws it, moving', async ({ page }) => {
  const options = { ...DEFAULT_EXPORT, textures: '256', clip: true, seconds: 3, start: 5 } as const;
  const asked: Asked = { species: aspen, seed: 2, wind, options };
  const [file] = await exportTree(aspen, 2, wind, options);
  await open(page);
  const got = await answer(page, asked);
  expect(got.hash).toBe(createHash('sha256').update(file!.bytes).digest('hex'));
  expect(got.stages).toEqual(['grow', 'textures', 'mesh', 'wind', 'write']);
  expect(got.seconds).toBeCloseTo(3, 5);
  expect(Object.fromEntries(got.images)).toEqual({
    'bark colour': 256,
    'bark normal': 256,
    'bark surface': 256,
    'leaf veins': 128,
  });
  expect(got.triangles).toBeGreaterThan(3000);
  expect(got.covered).toBeGreaterThan(0.03);
  expect(got.moved).toBeGreaterThan(0.005);
  // Leaves are green and bark is grey: more green than red, more red than blue.
  const [red, green, blue] = got.colour as [number, number, number];
  expect(green).toBeGreaterThan(red);
  expect(red).toBeGreaterThan(blue);
});

test('instances and levels of detail arrive, in as large a box as the tree', async ({ page }) => {
  await open(page);
  const asked = (more: Partial<typeof DEFAULT_EXPORT>): Asked => ({
    species: aspen,
    seed: 2,
    wind,
    options: { ...DEFAULT_EXPORT, textures: 'none', ...more },
  });
  const plain = await answer(page, asked({}));
  const instances = await answer(page, asked({ leaves: 'instances', lods: 'MSFT_lod', quantize: true }));
  expect(instances.bytes).toBeLessThan(0.6 * plain.bytes);
  instances.bounds.forEach((x, k) => {
    expect(Math.abs(x - plain.bounds[k]!)).toBeLessThan(0.15);
  });
  expect(instances.covered).toBeCloseTo(plain.covered, 2);
  expect(plain.moved).toBe(0);
});

test('an export that is called off ends at once, and the next one is made', async ({ page }) => {
  await open(page);
  const asked: Asked = { species: aspen, seed: 2, wind, options: { ...DEFAULT_EXPORT, clip: true, seconds: 60 } };
  const name = await page.evaluate((a) => (window as unknown as Window).windgroveExport.calledOff(a), asked);
  expect(name).toBe('AbortError');
  const options = { ...DEFAULT_EXPORT, textures: 'none' } as const;
  expect((await answer(page, { ...asked, options })).nodes).toBeGreaterThan(1);
});
