// Which browser the tests run in: one named by the caller, else the one inside an npm package, else Playwright's own, else one on the PATH.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '..');

/** Flags under which pictures are the same bytes everywhere: software GL, sRGB, no hinting. */
export const browserArgs = [
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--no-sandbox',
  '--force-color-profile=srgb',
  '--font-render-hinting=none',
  '--disable-lcd-text',
];

async function packaged() {
  if (process.platform !== 'linux' || process.arch !== 'x64') return undefined;
  const manifest = createRequire(import.meta.url)
    .resolve('@sparticuz/chromium')
    .split('/build/')[0];
  const { version } = JSON.parse(readFileSync(join(manifest, 'package.json'), 'utf8'));
  // The package unpacks into the temporary folder and reuses whatever lies there: give each version a folder of its own.
  const folder = join(root, 'node_modules', '.cache', `chromium-${version}`);
  mkdirSync(folder, { recursive: true });
  const before = process.env.TMPDIR;
  process.env.TMPDIR = folder;
  try {
    const { default: chromium } = await import('@sparticuz/chromium');
    return { name: `@sparticuz/chromium ${version}`, executablePath: await chromium.executablePath() };
  } finally {
    if (before === undefined) delete process.env.TMPDIR;
    else process.env.TMPDIR = before;
  }
}

async function playwrights() {
  const { chromium } = await import('@playwright/test');
  const executablePath = chromium.executablePath();
  return existsSync(executablePath) ? { name: "Playwright's chromium", executablePath } : undefined;
}

function onPath() {
  for (const name of ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable']) {
    const found = spawnSync(process.platform === 'win32' ? 'where' : 'which', [name], { encoding: 'utf8' });
    if (found.status === 0) return { name, executablePath: found.stdout.split('\n')[0].trim() };
  }
  return undefined;
}

/** Whether the browser starts at all: a missing system library shows here and not in every test. */
const starts = (browser) =>
  spawnSync(browser.executablePath, ['--version', '--no-sandbox'], { timeout: 30_000 }).status === 0;

/** `{ name, executablePath }` of the first browser that starts; throws with what was tried. */
export async function findBrowser() {
  const named = process.env.WINDGROVE_BROWSER;
  if (named) {
    if (!existsSync(named)) throw new Error(`WINDGROVE_BROWSER names ${named}, which does not exist.`);
    return { name: `WINDGROVE_BROWSER (${named})`, executablePath: named };
  }
  const tried = [];
  for (const look of [packaged, playwrights, onPath]) {
    try {
      const browser = await look();
      if (browser && starts(browser)) return browser;
      tried.push(`${look.name}: ${browser ? 'does not start' : 'none'}`);
    } catch (error) {
      tried.push(`${look.name}: ${error.message}`);
    }
  }
  throw new Error(
    `No browser for the tests (${tried.join('; ')}). Install Chromium or set WINDGROVE_BROWSER to its path.`,
  );
}
