// Trees a minute of `windgrove bake`, on 1 and on 2 threads, only packed and as GLB files, in turn in one run.
// `npx tsx bench/bake.ts` prints tables; with --json one line for `npm run bench`.
import { mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type BakePlan, itemsOf, parseSeeds } from '../src/cli/bake-plan.ts';
import { bakeAll } from '../src/cli/bake-pool.ts';
import type { BakedTree } from '../src/cli/bake-tree.ts';
import { findSpecies } from '../src/cli/species-files.ts';
import { findWind } from '../src/cli/wind-files.ts';
import { DEFAULT_EXPORT } from '../src/core/io/export-options.ts';
import { type BenchReport, sectionText } from './report.ts';

/** Trees of a round by species: a round of each takes some seconds. */
const TREES = { 'quaking-aspen': 8, 'black-tupelo': 4, 'weeping-willow': 2, 'california-black-oak': 2 } as const;
const ROUNDS = 3;
const JOBS = [1, 2] as const;
const AS = ['none', 'glb'] as const;

const median = (values: readonly number[]): number => values.toSorted((a, b) => a - b)[values.length >> 1]!;

const folder = mkdtempSync(join(tmpdir(), 'windgrove-bench-'));
const subjects = Object.entries(TREES).flatMap(([id, trees]) =>
  AS.map((format) => {
    const { species } = findSpecies(id);
    const plan: BakePlan = {
      species: [{ id, species }],
      seeds: `1..${trees}`,
      format,
      options: format === 'none' ? null : { ...DEFAULT_EXPORT, format },
      wind: findWind('still'),
    };
    return { name: species.name, format, trees, plan, times: JOBS.map(() => [] as number[]), bytes: 0 };
  }),
);

try {
  // The first round warms up: of threads too, which then are started anew, as a bake starts them.
  for (let round = 0; round <= ROUNDS; round++) {
    for (const subject of subjects) {
      for (const [k, jobs] of JOBS.entries()) {
        const items = itemsOf(1, parseSeeds(subject.plan.seeds), { part: 1, of: 1 });
        const made: BakedTree[] = [];
        const begin = performance.now();
        await bakeAll(subject.plan, items, folder, jobs, (tree) => made.push(tree));
        if (round > 0) subject.times[k]!.push(performance.now() - begin);
        subject.bytes = made.reduce((sum, { files = [] }) => sum + files.reduce((all, { bytes }) => all + bytes, 0), 0);
        for (const { files = [] } of made) for (const { file } of files) statSync(join(folder, file));
      }
    }
  }
} finally {
  rmSync(folder, { recursive: true, force: true });
}

const rows = subjects.map(({ name, format, trees, times, bytes }) => {
  const [one, two] = times.map((each) => (60_000 * trees) / median(each));
  return [name, format === 'none' ? 'packed only' : 'GLB', one!, two!, two! / one!, bytes / trees / 1e6];
});

const report: BenchReport = {
  title: 'Baking many trees',
  tables: [
    {
      caption: `Trees a minute on 1 and on 2 threads, medians of ${ROUNDS} rounds in turn`,
      columns: ['species', 'as', 'one thread', 'two threads', 'two to one', 'MB a tree'],
      rows,
    },
  ],
  notes: [
    `A round is ${Object.values(TREES).join(', ')} trees; the start of the threads counts, some tenths of a second, so that long bakes gain more ` +
      'from the second thread. Packed only: grown, fitted, packed and hashed. GLB: with the options that `windgrove bake` has by default (medium ' +
      'detail, 40 000 leaves at most as triangles, bark of 512 texels), written and checksummed.',
  ],
};

if (process.argv.includes('--json')) console.log(JSON.stringify(report));
else console.log(sectionText('bake', report, `Node ${process.version.slice(1)}`));
