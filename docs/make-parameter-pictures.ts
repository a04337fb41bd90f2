// `npx tsx docs/make-parameter-pictures.ts [PATH...]`: the two small pictures of each parameter that the editor's help shows.
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { PARAMETER_PICTURES, pictureIndex } from './parameter-pictures.ts';
import { docs, withPage } from './picture-browser.ts';

interface Pictures {
  readonly windgrovePictures: (path: string) => Promise<readonly string[]>;
}

const folder = join(docs, '../public/help');
const asked = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
let bytes = 0;

await withPage({ width: 280, height: 280 }, async (page, address) => {
  await page.goto(`${address}docs/parameter-picture.html`);
  await page.waitForFunction(() => 'windgrovePictures' in window, null, { timeout: 120_000 });
  for (const { path } of PARAMETER_PICTURES) {
    if (asked.length > 0 && !asked.includes(path)) continue;
    const pictures = await page.evaluate((p) => (window as unknown as Pictures).windgrovePictures(p), path);
    for (const [i, data] of pictures.entries()) {
      const picture = Buffer.from(data.split(',')[1]!, 'base64');
      bytes += picture.length;
      writeFileSync(join(folder, `${path}-${i === 0 ? 'low' : 'high'}.webp`), picture);
    }
    console.log(path);
  }
});

const there = (path: string): boolean =>
  ['low', 'high'].every((end) => existsSync(join(folder, `${path}-${end}.webp`)));
const spaced = (value: unknown): string =>
  Array.isArray(value) ? `[${value.map((v) => JSON.stringify(v)).join(', ')}]` : JSON.stringify(value);
const lines = Object.entries(pictureIndex(there)).map(
  ([path, { low, high }]) => `  ${JSON.stringify(path)}: { "low": ${spaced(low)}, "high": ${spaced(high)} }`,
);
writeFileSync(join(folder, 'index.json'), `{\n${lines.join(',\n')}\n}\n`);
console.log(`public/help: ${Math.round(bytes / 1024)} kB`);
