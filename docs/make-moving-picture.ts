// `npx tsx docs/make-moving-picture.ts [SPECIES [SEED]]`: the moving picture of the README, from frames that the library draws.
import { animatedWebp } from './animated-webp.ts';
import { save, webpOf, withPage } from './picture-browser.ts';

interface Picture {
  readonly windgrovePicture: { readonly show: (time: number) => void; readonly loop: number };
}

const [species = 'quaking-aspen', seed = '1'] = process.argv.slice(2);
const size = { width: 520, height: 600 };
const framesASecond = 12;

await withPage(size, async (page, address) => {
  await page.goto(`${address}docs/moving-picture.html?species=${species}&seed=${seed}`);
  await page.waitForFunction(() => 'windgrovePicture' in window, null, { timeout: 120_000 });
  const loop = await page.evaluate(() => (window as unknown as Picture).windgrovePicture.loop);
  const frames: Uint8Array[] = [];
  for (let n = 0; n < loop * framesASecond; n++) {
    await page.evaluate((time) => (window as unknown as Picture).windgrovePicture.show(time), n / framesASecond);
    frames.push(await webpOf(page, await page.screenshot(), 0.72));
  }
  save('windgrove.webp', animatedWebp(frames, { ...size, milliseconds: Math.round(1000 / framesASecond) }));
});
