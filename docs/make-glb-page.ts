// `npx tsx docs/make-glb-page.ts`: the pictures of docs/glb.md, its table of sizes and the validator's report, made anew.
// `--serve` keeps the page open with an aspen of its own: three.js alone, our GLB, its clip playing.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import validator from 'gltf-validator';
import { DEFAULT_EXPORT, type ExportOptions } from '../src/core/io/export-options.ts';
import { exportTree } from '../src/core/io/export-tree.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import { parseWind } from '../src/core/wind/parse-wind.ts';
import { docs, save, webpOf, withPage } from './picture-browser.ts';

const SPECIES = ['quaking-aspen', 'black-tupelo', 'california-black-oak', 'weeping-willow'] as const;
const SEED = 1;

const text = (file: string): string => readFileSync(join(docs, '../public', file), 'utf8');

async function glbOf(name: (typeof SPECIES)[number], more: Partial<ExportOptions>) {
  const { species } = parseSpecies(text(`species/${name}.json`));
  const { wind } = parseWind(text('winds/strong-breeze.json'));
  if (!species || !wind) throw new Error(`${name} or its wind has faults`);
  const before = process.cpuUsage();
  const [file] = await exportTree(species, SEED, wind, { ...DEFAULT_EXPORT, ...more });
  const { user, system } = process.cpuUsage(before);
  if (!file) throw new Error('no file');
  const { issues, info } = await validator.validateBytes(file.bytes, { maxIssues: 0 });
  return { name: species.name, bytes: file.bytes, seconds: (user + system) / 1e6, issues, info };
}

/** A row of the table for each way of writing a tree. */
const WAYS: readonly (readonly [words: string, options: Partial<ExportOptions>])[] = [
  ['low', { detail: 'low' }],
  ['medium', {}],
  ['medium, short numbers, leaves as instances', { quantize: true, leaves: 'instances' }],
  ['medium, clip of 6 s, bones on 2 levels', { clip: true }],
  ['medium, three levels of detail', { lods: 'MSFT_lod' }],
];

async function figures(): Promise<string> {
  const rows = [
    '| species | written as | triangles | MB | seconds of a CPU | errors, warnings |',
    '|---|---|---:|---:|---:|---|',
  ];
  for (const species of SPECIES) {
    for (const [words, options] of WAYS) {
      const { name, bytes, seconds, issues, info } = await glbOf(species, options);
      const triangles = Number(info.totalTriangleCount).toLocaleString('en');
      const size = (bytes.length / 1e6).toFixed(1);
      rows.push(
        `| ${name} | ${words} | ${triangles} | ${size} | ${seconds.toFixed(1)} | ${issues.numErrors}, ${issues.numWarnings} |`,
      );
      console.log(rows.at(-1));
    }
  }
  return rows.join('\n');
}

/** Puts text between two marks of docs/glb.md. */
function put(mark: string, lines: string): void {
  const file = join(docs, 'glb.md');
  const [before, rest] = readFileSync(file, 'utf8').split(`<!-- ${mark} -->\n`);
  const after = rest?.split(`<!-- end of ${mark} -->`)[1];
  if (before === undefined || after === undefined) throw new Error(`docs/glb.md has no marks for ${mark}`);
  writeFileSync(file, `${before}<!-- ${mark} -->\n${lines}\n<!-- end of ${mark} -->${after}`);
}

async function show(page: Page, address: string, bytes: Uint8Array, query: string): Promise<void> {
  await page.unrouteAll();
  await page.route(
    ({ pathname }) => pathname === '/tree.glb',
    (route) => route.fulfill({ body: Buffer.from(bytes), contentType: 'model/gltf-binary' }),
  );
  await page.goto(`${address}docs/glb.html?still&file=/tree.glb${query}`);
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true', null, { timeout: 300_000 });
}

interface Glb {
  readonly windgroveGlb: { readonly seek: (time: number) => void };
}

const seek = (page: Page, time: number): Promise<void> =>
  page.evaluate((t) => (window as unknown as Glb).windgroveGlb.seek(t), time);

const aspen = await glbOf('quaking-aspen', { detail: 'high', clip: true });

if (process.argv.includes('--serve')) {
  writeFileSync(join(docs, 'tree.glb'), aspen.bytes);
  console.log('docs/tree.glb: `npm start`, then open docs/glb.html?file=/docs/tree.glb');
} else {
  const report = {
    ...aspen.info,
    issues: aspen.issues,
  };
  put('report', ['```json', JSON.stringify(report, null, 2), '```'].join('\n'));
  await withPage({ width: 480, height: 640 }, async (page, address, browser) => {
    const sheet = await browser.newPage({ viewport: { width: 1440, height: 640 } });
    const pictures: string[] = [];
    await show(page, address, aspen.bytes, '');
    for (const time of [0, 2, 4]) {
      await seek(page, time);
      pictures.push((await page.screenshot({ timeout: 300_000 })).toString('base64'));
    }
    await sheet.setContent(
      `<body style="margin:0;display:flex">${pictures.map((data) => `<img src="data:image/png;base64,${data}">`).join('')}`,
    );
    save('glb-clip.webp', await webpOf(sheet, await sheet.screenshot({ timeout: 300_000 }), 0.85));
    await show(page, address, aspen.bytes, '&near');
    save('glb-near.webp', await webpOf(sheet, await page.screenshot({ timeout: 300_000 }), 0.85));
  });
  if (!process.argv.includes('--pictures')) put('figures', await figures());
}
