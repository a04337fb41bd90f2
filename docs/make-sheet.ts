// `npx tsx docs/make-sheet.ts ID [--view whole,crown,bark] [--season summer,winter] [--seeds 9] [--seed 1] [--bare] [--stage park] [--size 300x360]
// [--out FILE.png]`: a species as a sheet of small pictures, seeds across, views and seasons down; for judging it. Written to tmp/sheets, which git
// does not keep. ID may be a path to a file.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { parseArgs } from 'node:util';
import { docs, withPage } from './picture-browser.ts';
import type { SpeciesJob } from './species-picture.ts';

interface Pictures {
  readonly windgroveSpecies: (job: SpeciesJob) => Promise<string>;
}

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    view: { type: 'string', default: 'whole' },
    season: { type: 'string', default: 'summer' },
    seeds: { type: 'string', default: '9' },
    seed: { type: 'string', default: '1' },
    stage: { type: 'string', default: 'meadow' },
    size: { type: 'string', default: '300x360' },
    bare: { type: 'boolean', default: false },
    out: { type: 'string' },
  },
});

const [width, height] = values.size.split('x').map(Number) as [number, number];
const fileOf = (id: string): string => (existsSync(id) ? id : join(docs, `../public/species/${id}.json`));

await withPage({ width: 900, height: 600 }, async (page, address) => {
  await page.goto(`${address}docs/species-picture.html`);
  await page.waitForFunction(() => 'windgroveSpecies' in window, null, { timeout: 120_000 });
  const rows: string[][] = [];
  for (const id of positionals) {
    const text = readFileSync(fileOf(id), 'utf8');
    const kinds = values.season
      .split(',')
      .flatMap((season) =>
        values.view.split(',').map((view) => ({ season, view }) as Pick<SpeciesJob, 'season' | 'view'>),
      );
    const made: string[][] = kinds.map(() => []);
    for (let i = 0; i < Number(values.seeds); i++) {
      for (const [k, kind] of kinds.entries()) {
        const job = {
          text,
          seed: Number(values.seed) + i,
          hour: null,
          leaves: !values.bare,
          width,
          height,
          fine: 1.5,
          ...kind,
        };
        const data = await page.evaluate((j) => (window as unknown as Pictures).windgroveSpecies(j), {
          ...job,
          stage: values.stage as SpeciesJob['stage'],
        });
        made[k]!.push(data);
      }
    }
    rows.push(...made);
  }
  const across =
    Math.max(...rows.map((row) => row.length)) > 5 && rows.length === 1 ? 5 : Math.max(...rows.map((r) => r.length));
  const cells = rows.flatMap((row) => [
    ...row,
    ...Array.from({ length: (across - (row.length % across)) % across }, () => ''),
  ]);
  await page.setViewportSize({ width: across * (width + 4) + 4, height: 400 });
  await page.setContent(
    `<body style="margin:4px;background:#fbfaf6;display:grid;gap:4px;grid-template-columns:repeat(${across},${width}px)">${cells
      .map((data) => (data ? `<img src="${data}" width="${width}" height="${height}">` : '<i></i>'))
      .join('')}`,
  );
  const out = values.out ?? join(docs, `../tmp/sheets/${positionals.map((p) => p.replace(/\W+/g, '-')).join('+')}.png`);
  mkdirSync(dirname(out), { recursive: true });
  writeFileSync(out, await page.screenshot({ fullPage: true }));
  console.log(out);
});
