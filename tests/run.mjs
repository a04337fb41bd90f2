// `npm test`: types, lint, unit and browser tests, one after the other, each to its end, so that the closing line counts everything.
// `npm test -- unit` (or several names) runs only these stages.
import { spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { findBrowser } from '../e2e/browser.mjs';
import { countPlaywright, countVitest } from './reports.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '..');
const require = createRequire(import.meta.url);
const cache = join(root, 'node_modules', '.cache');
mkdirSync(cache, { recursive: true });
// A folder of its own for each run: a report that an earlier run left cannot be counted.
const reports = mkdtempSync(join(cache, 'test-reports-'));
const minutes = 60_000;

/** Path of the script behind a package's command: run with this Node, so that neither a shell nor the PATH matters. */
function command(packageName, name) {
  const manifest = require.resolve(`${packageName}/package.json`);
  const { bin } = JSON.parse(readFileSync(manifest, 'utf8'));
  return join(dirname(manifest), typeof bin === 'string' ? bin : bin[name]);
}

/** Runs a script of Node with its output shown as it comes; resolves to the exit status, 1 where there is none. */
function run(script, args, { env = {}, limit = 10 * minutes } = {}) {
  return new Promise((done) => {
    const child = spawn(process.execPath, [script, ...args], {
      cwd: root,
      stdio: ['ignore', 'inherit', 'inherit'],
      env: { ...process.env, ...env },
      timeout: limit,
    });
    child.on('error', (error) => {
      console.error(error.message);
      done(1);
    });
    child.on('close', (status, signal) => {
      if (signal) console.error(`Stopped by ${signal} (the stage may take ${limit / minutes} minutes).`);
      done(status ?? 1);
    });
  });
}

/** A stage that is one check: it passes or fails as a whole. */
const whole = (status) => ({ passed: status === 0 ? 1 : 0, failed: status === 0 ? 0 : 1, skipped: 0 });

/** Counts of a runner's report. A stage that failed without a failed test, or left no report, counts as one failure. */
function counted(status, file, count) {
  let counts = { passed: 0, failed: 0, skipped: 0 };
  try {
    counts = count(JSON.parse(readFileSync(file, 'utf8')));
  } catch (error) {
    console.error(`No report of this stage: ${error.message}`);
  }
  if (counts.failed === 0 && (status !== 0 || counts.passed === 0)) counts.failed = 1;
  return counts;
}

/** The first browser that starts; where none does, Playwright is asked once to install its own. */
async function browser() {
  try {
    return await findBrowser();
  } catch (error) {
    console.log(`${error.message}\nAsking Playwright for its own Chromium ...`);
    const status = await run(command('playwright', 'playwright'), ['install', 'chromium'], { limit: 10 * minutes });
    if (status !== 0) throw error;
    return await findBrowser();
  }
}

const stages = {
  types: async () => whole(await run(command('typescript', 'tsc'), ['--noEmit'])),
  lint: async () => whole(await run(command('@biomejs/biome', 'biome'), ['check', '.'])),
  unit: async () => {
    const file = join(reports, 'unit.json');
    const args = ['run', '--reporter=default', '--reporter=json', `--outputFile.json=${file}`];
    return counted(await run(command('vitest', 'vitest'), args), file, countVitest);
  },
  browser: async () => {
    let found;
    try {
      found = await browser();
    } catch (error) {
      console.error(error.message);
      return { passed: 0, failed: 1, skipped: 0 };
    }
    console.log(`Browser: ${found.name}`);
    const file = join(reports, 'browser.json');
    const status = await run(command('@playwright/test', 'playwright'), ['test', '--reporter=list,json'], {
      env: { WINDGROVE_BROWSER: found.executablePath, PLAYWRIGHT_JSON_OUTPUT_FILE: file },
      limit: 20 * minutes,
    });
    return counted(status, file, countPlaywright);
  },
};

const asked = process.argv.slice(2);
const unknown = asked.filter((name) => !(name in stages));
if (unknown.length > 0) {
  console.error(`No stage named ${unknown.join(', ')}; there are ${Object.keys(stages).join(', ')}.`);
  process.exit(2);
}

const rows = [];
for (const name of asked.length > 0 ? asked : Object.keys(stages)) {
  console.log(`\n== ${name}`);
  const start = performance.now();
  const counts = await stages[name]();
  rows.push({ name, ...counts, seconds: (performance.now() - start) / 1000 });
}
rmSync(reports, { recursive: true, force: true });

console.log('\n== result');
for (const { name, passed, failed, skipped, seconds } of rows) {
  const also = skipped > 0 ? `, ${skipped} skipped` : '';
  console.log(
    `${failed > 0 ? 'FAIL' : 'ok  '} ${name}: ${passed} passed, ${failed} failed${also} (${seconds.toFixed(1)} s)`,
  );
}
const sum = (key) => rows.reduce((total, row) => total + row[key], 0);
console.log(`\n${sum('passed')} passed, ${sum('failed')} failed`);
process.exitCode = sum('failed') > 0 ? 1 : 0;
