// Growing each species in Node beside ez-tree's "Ash Large" in the same process, in turn.
// `npx tsx bench/grow.ts` prints tables; with --json one line for `npm run bench`.
import { readFileSync } from 'node:fs';
import { grow } from '../src/core/grow/grow.ts';
import { growPacked } from '../src/core/pack/grow-packed.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import { type BenchReport, sectionText } from './report.ts';

const SPECIES = ['quaking-aspen', 'black-tupelo', 'weeping-willow', 'california-black-oak'];
/** Aims in milliseconds (the oak has none). */
const AIMS: Readonly<Record<string, number>> = { 'quaking-aspen': 20, 'black-tupelo': 80, 'weeping-willow': 1000 };
const ROUNDS = 9;
const WARM_UP = 4;

const median = (values: readonly number[]): number => values.toSorted((a, b) => a - b)[values.length >> 1];

interface Made {
  readonly stems: number;
  readonly leaves: number;
}

interface Subject {
  readonly name: string;
  readonly aim?: number;
  /** Makes the tree, and the milliseconds that took. */
  readonly run: (seed: number) => Made & { readonly milliseconds: number };
}

function timed(make: () => Made): Made & { milliseconds: number } {
  const begin = performance.now();
  const { stems, leaves } = make();
  return { stems, leaves, milliseconds: performance.now() - begin };
}

function windgrove(id: string, packed: boolean): Subject {
  const { species } = parseSpecies(readFileSync(new URL(`../public/species/${id}.json`, import.meta.url), 'utf8'));
  if (!species) throw new Error(`${id}: the species file is not valid`);
  return {
    name: packed ? `${species.name}, grown, fitted and packed` : species.name,
    aim: packed ? undefined : AIMS[id],
    run: (seed) =>
      timed(() => {
        const { stems, leaves } = packed ? growPacked(species, seed).tree : grow(species, seed);
        return { stems: stems.count, leaves: leaves.count };
      }),
  };
}

/** What is used of ez-tree's Tree. */
interface EzTree {
  readonly options: { seed: number };
  loadPreset(name: string): void;
  generate(): void;
  generateBranch(branch: unknown): void;
  generateLeaf(...place: unknown[]): void;
}

/** ez-tree in Node: its loaders of textures ask for elements of a page, which get nothing to load. */
async function ezTree(): Promise<Subject> {
  const element = { addEventListener() {}, removeEventListener() {}, style: {} };
  Object.assign(globalThis, { document: { createElementNS: () => element, createElement: () => element } });
  const { Tree } = (await import('@dgreenheck/ez-tree')) as unknown as { Tree: new () => EzTree };
  const tree = new Tree();
  tree.loadPreset('Ash Large');
  // Counted once beforehand, so that counting does not slow the rounds.
  const counter = new Tree();
  const made = { stems: 0, leaves: 0 };
  const { generateBranch, generateLeaf } = counter;
  counter.generateBranch = (branch) => {
    made.stems++;
    generateBranch.call(counter, branch);
  };
  counter.generateLeaf = (...place) => {
    made.leaves++;
    generateLeaf.apply(counter, place);
  };
  counter.loadPreset('Ash Large');
  return {
    name: 'ez-tree "Ash Large", generate()',
    run: (seed) =>
      timed(() => {
        tree.options.seed = seed;
        tree.generate();
        return made;
      }),
  };
}

const subjects = [
  ...SPECIES.map((id) => windgrove(id, false)),
  ...SPECIES.slice(0, 1).map((id) => windgrove(id, true)),
  await ezTree(),
];
const runs = subjects.map(() => [] as ReturnType<Subject['run']>[]);
for (let round = 0; round < WARM_UP + ROUNDS; round++) {
  for (const [i, subject] of subjects.entries()) {
    const run = subject.run(round);
    if (round >= WARM_UP) runs[i].push(run);
  }
}

const figures = runs.map((rounds) => ({
  stems: median(rounds.map((run) => run.stems)),
  leaves: median(rounds.map((run) => run.leaves)),
  milliseconds: median(rounds.map((run) => run.milliseconds)),
  microsecondsEach: median(rounds.map((run) => (1000 * run.milliseconds) / (run.stems + run.leaves))),
}));
const reference = figures[figures.length - 1].microsecondsEach;

const report: BenchReport = {
  title: 'Growing',
  tables: [
    {
      caption: `In Node, warmed up, medians of ${ROUNDS} rounds with another seed each, all in turn; aim: per stem and leaf at most a fifth of ez-tree's`,
      columns: ['tree', 'stems', 'leaves', 'ms', 'aim, ms', 'microseconds a stem or leaf', "part of ez-tree's"],
      rows: figures.map(({ stems, leaves, milliseconds, microsecondsEach }, i) => [
        subjects[i].name,
        stems,
        leaves,
        milliseconds,
        subjects[i].aim ?? '',
        microsecondsEach,
        microsecondsEach / reference,
      ]),
    },
  ],
  notes: [
    'Stems count clones. What ez-tree generates is a mesh at once; Windgrove makes none: its tree is ready for the GPU when it is fitted and packed, ' +
      'so that the row of the aspen with all three stages is the fairer one beside it.',
  ],
};

if (process.argv.includes('--json')) console.log(JSON.stringify(report));
else console.log(sectionText('grow', report, `Node ${process.version.slice(1)}`));
