// `npx tsx docs/make-icons.ts`: public/icons/*.png from public/icon.svg, for home screens, which take no SVG.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { type Browser, chromium } from '@playwright/test';
import { browserArgs, findBrowser } from '../e2e/browser.mjs';

/** An icon: its side in pixels, and the part of it that the drawing takes. */
interface Icon {
  readonly file: string;
  readonly side: number;
  readonly part: number;
  /** What stands behind the drawing; null: nothing. */
  readonly paper: string | null;
}

const PAPER = '#fbfaf6';
/** Home screens cut maskable icons to a circle of 80 % of their side; what is drawn stays within. */
const ICONS: readonly Icon[] = [
  { file: 'icon-192.png', side: 192, part: 0.88, paper: null },
  { file: 'icon-512.png', side: 512, part: 0.88, paper: null },
  { file: 'icon-maskable-512.png', side: 512, part: 0.56, paper: PAPER },
  { file: 'icon-180.png', side: 180, part: 0.74, paper: PAPER },
];

const folder = join(import.meta.dirname, '../public/icons');
const drawing = Buffer.from(readFileSync(join(folder, '../icon.svg'), 'utf8')).toString('base64');

async function draw(browser: Browser, { file, side, part, paper }: Icon): Promise<void> {
  const page = await browser.newPage({ viewport: { width: side, height: side }, deviceScaleFactor: 1 });
  await page.setContent(
    `<body style="margin:0;display:grid;place-items:center;height:100vh;background:${paper ?? 'transparent'}"><img alt="" style="width:${100 * part}%" src="data:image/svg+xml;base64,${drawing}">`,
    { waitUntil: 'load' },
  );
  const png = await page.screenshot({ omitBackground: paper === null });
  writeFileSync(join(folder, file), png);
  console.log(`public/icons/${file}: ${(png.length / 1000).toFixed(1)} kB`);
  await page.close();
}

mkdirSync(folder, { recursive: true });
const { executablePath } = await findBrowser();
const browser = await chromium.launch({ executablePath, args: browserArgs });
for (const icon of ICONS) await draw(browser, icon);
await browser.close();
