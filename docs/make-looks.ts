// `npx tsx docs/make-looks.ts [PRESET...]`: docs/looks, each preset of ez-tree beside a species of ours: near, middle, far, and three seconds.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { PAIRS, type Pair } from '../bench/pairs.ts';
import { docs, withPage } from './picture-browser.ts';

interface Looks {
  readonly windgroveLook: (pair: Pair) => Promise<string>;
}

const folder = join(docs, 'looks');
const pictureOf = ({ preset }: Pair): string => `${preset.toLowerCase().replace(/\W+/g, '-')}.webp`;
/** `swamp-white-oak` as `Swamp white oak`. */
const nameOf = (id: string): string => `${id[0]!.toUpperCase()}${id.slice(1).replaceAll('-', ' ')}`;
const asked = process.argv.slice(2);
mkdirSync(folder, { recursive: true });

await withPage({ width: 800, height: 600 }, async (page, address) => {
  await page.goto(`${address}docs/looks.html`);
  await page.waitForFunction(() => 'windgroveLook' in window, null, { timeout: 120_000 });
  for (const pair of PAIRS) {
    if (asked.length > 0 && !asked.includes(pair.preset)) continue;
    const data = await page.evaluate((p) => (window as unknown as Looks).windgroveLook(p), pair);
    const name = pictureOf(pair);
    const bytes = Buffer.from(data.split(',')[1]!, 'base64');
    writeFileSync(join(folder, name), bytes);
    console.log(`docs/looks/${name}: ${Math.round(bytes.length / 1024)} kB`);
  }
});

const rows = PAIRS.map(
  (pair) =>
    `## ${nameOf(pair.species)}, seed ${pair.seed}${pair.season === 'summer' ? '' : `, ${pair.season}`} | ez-tree "${pair.preset}"\n\n![](looks/${pictureOf(pair)})\n`,
);
writeFileSync(
  join(docs, 'looks.md'),
  `# Beside ez-tree

Each of the sixteen presets of ez-tree 1.1.0 beside a species of ours: the same height, camera, light and ground, near, from where the whole tree is seen, and from afar; ours above,
theirs below. Under them three seconds of each in its own wind, half a second and a little from picture to picture: ours bends from the trunk up, theirs moves its leaves.
\`npx tsx docs/make-looks.ts\` takes the pictures again. Frame times of each pair: [bench/results.md](../bench/results.md).

${rows.join('\n')}`,
);
