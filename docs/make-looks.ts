// `npx tsx docs/make-looks.ts [PRESET...]`: docs/looks, each preset of ez-tree beside a species of ours: near, middle, far, and three seconds.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { PAIRS, type Pair } from '../bench/pairs.ts';
import { docs, withPage } from './picture-browser.ts';

interface Looks {
  readonly windgroveLook: (pair: Pair) => Promise<string>;
}

const folder = join(docs, 'looks');
const asked = process.argv.slice(2);
mkdirSync(folder, { recursive: true });

await withPage({ width: 800, height: 600 }, async (page, address) => {
  await page.goto(`${address}docs/looks.html`);
  await page.waitForFunction(() => 'windgroveLook' in window, null, { timeout: 120_000 });
  for (const pair of PAIRS) {
    if (asked.length > 0 && !asked.includes(pair.preset)) continue;
    const data = await page.evaluate((p) => (window as unknown as Looks).windgroveLook(p), pair);
    const name = `${pair.preset.toLowerCase().replace(/\W+/g, '-')}.webp`;
    const bytes = Buffer.from(data.split(',')[1]!, 'base64');
    writeFileSync(join(folder, name), bytes);
    console.log(`docs/looks/${name}: ${Math.round(bytes.length / 1024)} kB`);
  }
});
