// `npx tsx docs/make-wind-strips.ts [SPECIES [SEED]]`: a strip of frames for each of three winds, half a second apart.
import { save, webpOf, withPage } from './picture-browser.ts';

interface Strip {
  readonly windgroveStrip: { readonly show: (time: number) => void };
}

const [species = 'quaking-aspen', seed = '1'] = process.argv.slice(2);
const winds = ['breeze', 'gale', 'storm'];
const frame = { width: 240, height: 360 };
const frames = 6;
/** When the first frame is taken, and the time between two, seconds: the branches swing since time 0. */
const from = 20;
const apart = 0.5;

await withPage(frame, async (page, address, browser) => {
  const sheet = await browser.newPage({ viewport: { width: frame.width * frames, height: frame.height } });
  for (const wind of winds) {
    await page.goto(`${address}docs/wind-strip.html?species=${species}&seed=${seed}&wind=${wind}`);
    await page.waitForFunction(() => 'windgroveStrip' in window, null, { timeout: 120_000 });
    const pictures: string[] = [];
    for (let n = 0; n < frames; n++) {
      await page.evaluate((time) => (window as unknown as Strip).windgroveStrip.show(time), from + n * apart);
      pictures.push((await page.screenshot()).toString('base64'));
    }
    await sheet.setContent(
      `<body style="margin:0;display:flex">${pictures
        .map((data) => `<img style="width:${frame.width}px" src="data:image/png;base64,${data}">`)
        .join('')}`,
    );
    save(`wind-${wind}.webp`, await webpOf(sheet, await sheet.screenshot(), 0.8));
  }
});
