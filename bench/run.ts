// `npm run bench [-- NAME...]`: runs the benches, one after the other, and writes their tables to bench/results.md.
// Every figure is taken beside the one that it is compared with, in the same run; only such ratios travel to other machines.
import { spawn } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { cpus, totalmem } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { type Browser, chromium } from '@playwright/test';
import { createServer } from 'vite';
import { browserArgs, findBrowser } from '../e2e/browser.mjs';
import { type BenchReport, type FailedReport, sectionText, withSection } from './report.ts';
import { type WindTimings, windReport } from './wind-tables.ts';

const root = join(import.meta.dirname, '..');

/** The benches: scripts for Node and pages for the browser, in the order of the report. */
const benches: readonly { name: string; file: string; query?: string }[] = [
  { name: 'grow', file: 'grow.ts' },
  { name: 'pack', file: 'pack.ts' },
  { name: 'bake', file: 'bake.ts' },
  { name: 'order', file: 'order.html' },
  { name: 'wind', file: 'wind.html' },
  { name: 'deform', file: 'deform.html' },
  { name: 'edit', file: 'edit.html' },
  { name: 'compare', file: 'compare-ez-tree.html', query: '?measure' },
  // Each part of the page by itself: a part that is run again replaces its own section.
  ...['one', 'hundred', 'far', 'classes', 'count', 'papers'].map((part) => ({
    name: `forest-${part}`,
    file: '../bench.html',
    query: `?run&only=${part}`,
  })),
];

/** Sizes that the parts of the forest's page take: `--rounds 1 --ms 50 --trees 20 --counts 1,10`. */
const { values: sizes, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    rounds: { type: 'string', default: '3' },
    ms: { type: 'string', default: '200' },
    trees: { type: 'string', default: '100' },
    counts: { type: 'string', default: '1,10,100,1000,10000' },
    out: { type: 'string' },
  },
});

/** What a page of the forest is asked for besides. */
const sizesOf = (name: string): string => {
  const { rounds, ms, trees, counts } = sizes;
  return name.startsWith('forest-') ? `&rounds=${rounds}&ms=${ms}&trees=${trees}&counts=${counts}` : '';
};

const head = `# Results

Written by \`npm run bench\`. Absolute times hold for the machine that they were taken on; the ratios are of figures taken in turn in
one run and travel better. How each bench measures is said in its source; [README.md](README.md) says how to read and run them.
`;

/** What a bench hands over as a report; the page of the wind pass hands over bare timings. */
function reportOf(json: string): BenchReport | FailedReport {
  const value = JSON.parse(json) as BenchReport | FailedReport | WindTimings;
  return 'rows' in value ? windReport(value) : value;
}

/** JSON that the script prints as its last line. */
async function runScript(file: string): Promise<BenchReport | FailedReport> {
  const require = createRequire(import.meta.url);
  const loader = require.resolve('tsx');
  const output = await new Promise<string>((done, fail) => {
    const args = ['--expose-gc', '--import', loader, file, '--json'];
    const child = spawn(process.execPath, args, { cwd: root, stdio: ['ignore', 'pipe', 'inherit'] });
    let text = '';
    child.stdout.on('data', (chunk: Buffer) => {
      text += chunk.toString();
    });
    child.on('error', fail);
    child.on('close', (status) => (status === 0 ? done(text) : fail(new Error(`${file} ended with status ${status}`))));
  });
  return reportOf(output.trim().split('\n').at(-1)!);
}

/** JSON that the page writes into #report when it is done. */
async function runPage(browser: Browser, url: string): Promise<BenchReport | FailedReport> {
  const page = await browser.newPage({ viewport: { width: 1024, height: 640 }, deviceScaleFactor: 1 });
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('console', (message) => message.type() === 'log' && console.log(`  ${message.text()}`));
  try {
    await page.goto(url);
    const done = await page.waitForFunction(() => document.querySelector('#report')?.textContent?.trim(), null, {
      timeout: 30 * 60_000,
      polling: 500,
    });
    return reportOf(String(await done.jsonValue()));
  } catch (error) {
    return { error: [...errors, String(error)].join('\n') };
  } finally {
    await page.close();
  }
}

/** Forests have a file of their own: one for all would be too long to read. */
const fileOf = (name: string): string => sizes.out ?? (name.startsWith('forest-') ? 'results-forest.md' : 'results.md');
/** The benches by name; `forest` is all parts of its page. */
const asked = positionals.flatMap((name) =>
  name === 'forest' ? benches.map((each) => each.name).filter((each) => each.startsWith('forest-')) : [name],
);
const known = benches.map(({ name }) => name);
const unknown = asked.filter((name) => !known.includes(name));
if (unknown.length > 0) throw new Error(`No bench named ${unknown.join(', ')}; there are ${known.join(', ')}.`);

const found = await findBrowser();
const browser = await chromium.launch({ executablePath: found.executablePath, args: browserArgs });
const server = await createServer({
  root,
  logLevel: 'warn',
  server: { host: '127.0.0.1', open: false, hmr: false, watch: null },
});
await server.listen();
const { port } = server.httpServer!.address() as { port: number };

const cores = cpus();
const machine = `${cores.length} cores (${cores[0]?.model.trim()}), ${Math.round(totalmem() / 2 ** 30)} GiB`;
const circumstances = (page: boolean): string =>
  `${new Date().toISOString().slice(0, 10)}; ${machine}; Node ${process.version.slice(1)}${
    page ? `; Chromium ${browser.version()} (${found.name.replace(/ .*/, '')})` : ''
  }.`;

let failures = 0;
try {
  for (const { name, file, query = '' } of benches) {
    if (asked.length > 0 && !asked.includes(name)) continue;
    if (!existsSync(join(import.meta.dirname, file))) {
      console.error(`${name}: bench/${file} is not there`);
      failures += 1;
      continue;
    }
    console.log(`${name} ...`);
    const isPage = file.endsWith('.html');
    const report = await (isPage
      ? runPage(browser, new URL(file + query + sizesOf(name), `http://127.0.0.1:${port}/bench/`).href)
      : runScript(join('bench', file))
    ).catch((error: unknown): FailedReport => ({ error: String(error) }));
    if ('error' in report) {
      console.error(`${name}: ${report.error}`);
      failures += 1;
      continue;
    }
    const results = join(import.meta.dirname, fileOf(name));
    const text = existsSync(results) ? readFileSync(results, 'utf8') : head;
    console.log(`written to bench/${fileOf(name)}`);
    writeFileSync(results, withSection(text, name, sectionText(name, report, circumstances(isPage))));
  }
} finally {
  await browser.close();
  await server.close();
}
if (failures > 0) console.log(`${failures} failed`);
process.exitCode = failures > 0 ? 1 : 0;
