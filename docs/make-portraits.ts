// `npx tsx docs/make-portraits.ts [--missing] [ID...]`: the pictures of the gallery, of all species that ship, of some, or those that are missing: portrait, thumbnail and one small
// picture of each season that differs, on the meadow. A species' best seed stands as `seed` in public/species/index.json; 1 where there is none.
import { existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { type IndexEntry, seedOf } from '../src/core/file/shipped-index.ts';
import { SEASONS, type Season } from '../src/core/species/season.ts';
import { shippedFacts } from '../src/core/species/shipped-facts.ts';
import { withPage } from './picture-browser.ts';
import {
  folder,
  IN_SEASON,
  indexText,
  PORTRAIT,
  portraitOf,
  readEntry,
  readIndex,
  seasonOf,
  THUMBNAIL,
  thumbnailOf,
  wholeEntry,
} from './species-index.ts';
import type { SpeciesJob } from './species-picture.ts';

interface Pictures {
  readonly windgroveSpecies: (job: SpeciesJob, most?: number) => Promise<string>;
}

interface Wanted {
  readonly path: string;
  readonly season: Season;
  readonly size: { readonly width: number; readonly height: number; readonly bytes: number };
}

const asked = process.argv.slice(2).filter((word) => word !== '--missing');
const missing = process.argv.includes('--missing');
const chosen = readIndex().filter(({ id }) => asked.length === 0 || asked.includes(id));
const unknown = asked.filter((id) => !chosen.some((entry) => entry.id === id));
if (unknown.length > 0) throw new Error(`Not in the list: ${unknown.join(', ')}`);
mkdirSync(join(folder, 'portraits'), { recursive: true });

const wantedOf = (entry: IndexEntry): Wanted[] => {
  const { id } = entry;
  const { seasons } = shippedFacts(readEntry(entry).species);
  return [
    { path: portraitOf(id), season: 'summer', size: PORTRAIT },
    { path: thumbnailOf(id), season: 'summer', size: THUMBNAIL },
    ...seasons.map((season) => ({ path: seasonOf(id, season), season, size: IN_SEASON })),
  ];
};

await withPage({ width: 900, height: 700 }, async (page, address) => {
  await page.goto(`${address}docs/species-picture.html`);
  await page.waitForFunction(() => 'windgroveSpecies' in window, null, { timeout: 120_000 });
  for (const entry of chosen) {
    const { text } = readEntry(entry);
    const wanted = wantedOf(entry);
    if (missing && wanted.every(({ path }) => existsSync(join(folder, path)))) continue;
    const sizes: string[] = [];
    for (const { path, season, size } of wanted) {
      const { width, height, bytes } = size;
      const job: SpeciesJob = {
        text,
        seed: seedOf(entry),
        season,
        stage: 'meadow',
        hour: null,
        view: 'close',
        leaves: true,
        width,
        height,
        fine: 2,
      };
      const data = await page.evaluate(([j, most]) => (window as unknown as Pictures).windgroveSpecies(j, most), [
        job,
        bytes,
      ] as const);
      const written = Buffer.from(data.split(',')[1]!, 'base64');
      writeFileSync(join(folder, path), written);
      sizes.push(`${(written.length / 1000).toFixed(1)}`);
    }
    for (const season of SEASONS) {
      const path = seasonOf(entry.id, season);
      if (!wanted.some((each) => each.path === path)) rmSync(join(folder, path), { force: true });
    }
    console.log(`${entry.id}: ${sizes.join(', ')} kB`);
  }
});

writeFileSync(join(folder, 'index.json'), indexText(readIndex().map(wholeEntry)));
