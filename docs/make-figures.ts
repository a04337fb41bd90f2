// `npx tsx docs/make-figures.ts [LESSON...]`: a still picture of every figure of the lessons, for where no script draws it.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { LESSONS } from '../src/learn/lessons.ts';
import { docs, withPage } from './picture-browser.ts';

/** Pixels across, and bytes that a picture may have. */
const [WIDE, MOST] = [640, 10_000];

interface Still {
  readonly width: number;
  readonly height: number;
  readonly alt: string;
  readonly drawn: boolean;
}

const table = join(docs, '../src/learn/stills.json');
const stills: Record<string, Still> = existsSync(table) ? JSON.parse(readFileSync(table, 'utf8')) : {};
const asked = process.argv.slice(2);

await withPage({ width: 1280, height: 900 }, async (page, address) => {
  // Time stands still, so that the same pictures are taken again.
  await page.emulateMedia({ reducedMotion: 'reduce' });
  for (const { slug } of LESSONS) {
    if (asked.length > 0 && !asked.includes(slug)) continue;
    await page.goto(`${address}learn/${slug}.html`);
    const folder = join(docs, '../public/figures', slug);
    mkdirSync(folder, { recursive: true });
    let bytes = 0;
    for (const figure of await page.locator('figure.live').all()) {
      const id = (await figure.getAttribute('data-figure')) as string;
      await figure.evaluate((element) => element.scrollIntoView({ block: 'center' }));
      await page.waitForFunction((name) => document.querySelector(`[data-figure="${name}"]`)?.matches('.shown'), id, {
        timeout: 240_000,
      });
      // Rules and textures that come later than the tree.
      await page.waitForLoadState('networkidle');
      await figure.evaluate(async (element) => {
        const canvas = element.querySelector('canvas') as HTMLCanvasElement;
        let last = '';
        for (let same = 0; same < 20; same++) {
          await new Promise((done) => requestAnimationFrame(done));
          const now = canvas.toDataURL();
          if (now !== last) same = 0;
          last = now;
        }
      });
      const taken = await figure.evaluate(
        (element, [wide, most]) => {
          const canvas = element.querySelector('canvas') as HTMLCanvasElement;
          const small = document.createElement('canvas');
          const context = small.getContext('2d') as CanvasRenderingContext2D;
          const drawn = canvas.dataset.scene === undefined;
          let data = '';
          // What is too large at a low quality is taken smaller.
          for (let width = wide; width > 300; width *= 0.8) {
            small.width = Math.round(width);
            small.height = Math.round((width * canvas.height) / canvas.width);
            context.drawImage(canvas, 0, 0, small.width, small.height);
            // Lines on nothing take more bytes than lines on the stage's own colour.
            context.globalCompositeOperation = 'destination-over';
            context.fillStyle = getComputedStyle(canvas.parentElement as HTMLElement).backgroundColor;
            context.fillRect(0, 0, small.width, small.height);
            for (let quality = 0.8; quality > 0.3; quality -= 0.1) {
              data = small.toDataURL('image/webp', quality).split(',')[1] ?? '';
              if (data.length * 0.75 <= most) break;
            }
            if (data.length * 0.75 <= most) break;
          }
          const alt = canvas.getAttribute('aria-label') ?? '';
          return { data, still: { width: small.width, height: small.height, alt, drawn } };
        },
        [WIDE, MOST] as const,
      );
      const picture = Buffer.from(taken.data, 'base64');
      bytes += picture.length;
      writeFileSync(join(folder, `${id}.webp`), picture);
      stills[`${slug}/${id}`] = taken.still;
    }
    console.log(`public/figures/${slug}: ${Math.round(bytes / 1024)} kB`);
  }
});

writeFileSync(table, `${JSON.stringify(stills, null, 2)}\n`);
