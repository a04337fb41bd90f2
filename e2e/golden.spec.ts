import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { decode } from 'fast-png';
import type { SpeciesJob } from '../docs/species-picture.ts';

// Small pictures as they were when somebody last looked at them. WINDGROVE_GOLDEN=write makes them anew: look at them before they are kept.
const folder = join(import.meta.dirname, 'golden');

/** One of each kind: flat leaves, a weeping crown, needles, fronds, ribs, blossom on bare twigs. */
const SUBJECTS: readonly (readonly [species: string, season: SpeciesJob['season'], view: SpeciesJob['view']])[] = [
  ['quaking-aspen', 'autumn', 'close'],
  ['weeping-willow', 'summer', 'close'],
  ['balsam-fir', 'summer', 'close'],
  ['queen-palm', 'summer', 'close'],
  ['saguaro-cactus', 'summer', 'close'],
  ['cherry', 'spring', 'close'],
];

/** Part of a picture's channels that may be off by more than STEP of 255, and the mean of all of them that may be. */
const STEP = 24;
const MOST = 0.02;
const MEAN = 1.5;

const bytesOf = (data: string): Buffer => Buffer.from(data.split(',')[1]!, 'base64');

interface Pictures {
  readonly windgroveSpecies: (job: SpeciesJob) => Promise<string>;
}

test('six species look as they did', async ({ page }) => {
  await page.goto('e2e/pages/golden.html');
  await page.waitForFunction(() => 'windgroveSpecies' in window);
  const off: string[] = [];
  for (const [species, season, view] of SUBJECTS) {
    const text = readFileSync(join(import.meta.dirname, `../public/species/${species}.json`), 'utf8');
    const job: SpeciesJob = {
      ...{ text, season, view, seed: 1, stage: 'meadow', hour: null, leaves: true },
      ...{ width: 120, height: 150, fine: 2, png: true },
    };
    const data = await page.evaluate((j) => (window as unknown as Pictures).windgroveSpecies(j), job);
    const file = join(folder, `${species}.png`);
    if (process.env.WINDGROVE_GOLDEN === 'write') {
      mkdirSync(folder, { recursive: true });
      writeFileSync(file, bytesOf(data));
      continue;
    }
    const [now, then] = [decode(bytesOf(data)), decode(readFileSync(file))];
    expect([now.width, now.height], species).toEqual([then.width, then.height]);
    let sum = 0;
    let far = 0;
    for (let i = 0; i < now.data.length; i++) {
      const by = Math.abs(now.data[i]! - then.data[i]!);
      sum += by;
      if (by > STEP) far++;
    }
    const [mean, part] = [sum / now.data.length, far / now.data.length];
    if (mean > MEAN || part > MOST)
      off.push(`${species}: ${mean.toFixed(2)} of 255 on the mean, ${(100 * part).toFixed(1)} % far off`);
  }
  expect(off).toEqual([]);
});
