// `npx tsx docs/make-comparison.ts`: Windgrove's tree and ez-tree's in the same scene, near and far, side by side.
import { save, withPage } from './picture-browser.ts';

const half = { width: 640, height: 720 };

/** What stands on the left and on the right of each picture. */
const contestants = [
  { query: 'tree=windgrove&species=quaking-aspen', caption: 'Windgrove, quaking aspen' },
  { query: 'tree=ez-tree&preset=Ash%20Large', caption: 'ez-tree 1.1.0, Ash Large' },
];

await withPage(half, async (page, address) => {
  for (const view of ['near', 'whole', 'far']) {
    const pictures: string[] = [];
    for (const { query } of contestants) {
      await page.setViewportSize(half);
      await page.goto(`${address}bench/compare-ez-tree.html?${query}&view=${view}`);
      await page.waitForFunction(() => document.body.dataset.ready === 'true', null, { timeout: 120_000 });
      pictures.push((await page.screenshot()).toString('base64'));
    }
    await page.setViewportSize({ width: half.width * 2, height: half.height + 32 });
    await page.setContent(`
      <body style="margin: 0; font: 15px/32px system-ui, sans-serif; color: #1d2021; background: #fbfaf6">
        <div style="display: grid; grid-template-columns: 1fr 1fr; text-align: center">
          ${pictures.map((data) => `<img style="display: block" src="data:image/png;base64,${data}">`).join('')}
          ${contestants.map(({ caption }) => `<span>${caption}</span>`).join('')}
        </div>
      </body>`);
    save(`compare-${view}.png`, await page.screenshot());
  }
});
