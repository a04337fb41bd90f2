import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import {
  appendFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  watch,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { BakeJournal } from '../../src/cli/bake-journal.ts';
import { textOf } from '../house/tree-files.ts';
import { call, scratchFolder } from './call.ts';

const root = join(import.meta.dirname, '../..');
const folder = scratchFolder();

/** A bake of a dozen small files. */
const BAKE = ['bake', 'quaking-aspen', '--seeds', '1..12', '--format', 'swc', '--levels', '2'];

interface Tree {
  readonly index: number;
  readonly species: string;
  readonly seed: number;
  readonly hash?: string;
  readonly error?: string;
  readonly files?: readonly { readonly file: string; readonly bytes: number; readonly sha256: string }[];
}

const manifestText = (out: string): string => readFileSync(join(out, 'manifest.json'), 'utf8');
const treesOf = (out: string): Tree[] => JSON.parse(manifestText(out)).trees as Tree[];

/** Bakes without a break, once for all tests. */
const whole = join(folder, 'whole');
const undisturbed = call(...BAKE, '--out', whole);

/** Starts the command as its own process and kills it as soon as its journal has some trees, but not all. */
async function bakeAndKill(out: string): Promise<number> {
  mkdirSync(out);
  const journal = join(out, '.bake-1-of-1.jsonl');
  const lines = (): number => (existsSync(journal) ? readFileSync(journal, 'utf8').split('\n').length - 2 : 0);
  const args = ['--import', 'tsx', join(root, 'src/cli/main.ts'), ...BAKE, '--out', out];
  const child = spawn(process.execPath, args, { cwd: root, stdio: 'ignore' });
  const watcher = watch(out, () => {
    if (lines() >= 3) child.kill('SIGKILL');
  });
  const signal = await new Promise((done) => child.on('close', (_, by) => done(by)));
  watcher.close();
  expect(signal).toBe('SIGKILL');
  return lines();
}

describe('a bake', () => {
  test('lists its trees with files, sizes, checksums, figures, and hashes equal to those of the browser', async () => {
    expect(await undisturbed).toEqual({ status: 0, out: `12 trees in ${whole}, listed in manifest.json`, err: '' });
    const trees = treesOf(whole);
    expect(trees.map(({ index, seed }) => [index, seed])).toEqual(Array.from({ length: 12 }, (_, i) => [i, i + 1]));
    for (const { files = [] } of trees) {
      const [{ file, bytes, sha256 }] = files as [{ file: string; bytes: number; sha256: string }];
      const content = readFileSync(join(whole, file));
      expect([content.length, createHash('sha256').update(content).digest('hex')]).toEqual([bytes, sha256]);
    }
    expect(trees[0]).toMatchObject({ species: 'quaking-aspen', stems: 754, leaves: 13557 });
    expect(readdirSync(whole).sort()).toEqual(['manifest.json', 'quaking-aspen']);
  });

  test('of every species has the hashes that are written down for the browser', async () => {
    const out = join(folder, 'hashes');
    const known = [...textOf('tests/core/pack/species.test.ts').matchAll(/'([a-z-]+)': '([0-9a-f]{8})'/g)];
    expect(known).toHaveLength(4);
    await call('bake', ...known.map(([, name]) => name!), '--seeds', '1', '--format', 'none', '--out', out);
    expect(treesOf(out).map(({ species, hash }) => [species, hash])).toEqual(known.map(([, ...pair]) => pair));
  });

  test('that was killed goes on where it was, and ends as if nothing had been', async () => {
    const out = join(folder, 'killed');
    const done = await bakeAndKill(out);
    expect(done).toBeGreaterThan(0);
    expect(done).toBeLessThan(12);
    expect(existsSync(join(out, 'manifest.json'))).toBe(false);
    // As if the kill had come in the midst of a line, and of a file.
    appendFileSync(join(out, '.bake-1-of-1.jsonl'), '{"index":11,"species":"quaki');
    writeFileSync(join(out, 'quaking-aspen', 'quaking-aspen-12.swc.part'), '# half');
    const first = join(out, 'quaking-aspen', 'quaking-aspen-1.swc');
    const before = statSync(first).mtimeMs;
    const { status, err } = await call(...BAKE, '--out', out);
    expect([status, err]).toEqual([0, `${done} of 12 trees were done before.`]);
    await undisturbed;
    expect(manifestText(out)).toBe(manifestText(whole));
    expect(statSync(first).mtimeMs).toBe(before);
    expect(readdirSync(join(out, 'quaking-aspen')).sort()).toEqual(readdirSync(join(whole, 'quaking-aspen')).sort());
    expect(readdirSync(out).sort()).toEqual(['manifest.json', 'quaking-aspen']);
  });

  test('that lost a file makes it again, and one that is whole makes none', async () => {
    const out = join(folder, 'again');
    await call(...BAKE, '--out', out);
    rmSync(join(out, 'quaking-aspen', 'quaking-aspen-5.swc'));
    expect((await call(...BAKE, '--out', out)).err).toBe('11 of 12 trees were done before.');
    expect((await call(...BAKE, '--out', out)).err).toBe('12 of 12 trees were done before.');
    await undisturbed;
    expect(manifestText(out)).toBe(manifestText(whole));
  });

  test('in three shards is the same when they are put together, in whatever order and by however many threads', async () => {
    const out = join(folder, 'shards');
    for (const shard of ['3/3', '1/3', '2/3'])
      expect((await call(...BAKE, '--out', out, '--shard', shard, '--jobs', shard === '1/3' ? '2' : '1')).status).toBe(
        0,
      );
    expect(await call('bake', '--merge', out)).toEqual({
      status: 0,
      out: `12 trees in ${out}, listed in manifest.json`,
      err: '',
    });
    await undisturbed;
    expect(manifestText(out)).toBe(manifestText(whole));
  });

  test('is not put together while a shard is missing', async () => {
    const out = join(folder, 'missing');
    const bake = ['bake', 'quaking-aspen', '--seeds', '1..3', '--format', 'none', '--out', out];
    await call(...bake, '--shard', '1/3');
    await call(...bake, '--shard', '3/3');
    expect(await call('bake', '--merge', out)).toEqual({ status: 1, out: '', err: `${out}: shard 2/3 not there yet.` });
  });

  test('says in its manifest which trees could not be grown, and why', async () => {
    const flat = JSON.parse(readFileSync(join(root, 'public/species/quaking-aspen.json'), 'utf8'));
    flat.levels[0].length = 0;
    const file = join(folder, 'flat.json');
    writeFileSync(file, JSON.stringify(flat));
    const out = join(folder, 'flat');
    const { status, err } = await call('bake', file, 'quaking-aspen', '--seeds', '7', '--format', 'none', '--out', out);
    expect([status, err]).toEqual([1, '1 of them could not be grown: the manifest says why.']);
    expect(treesOf(out).map(({ error }) => error)).toEqual([
      'The trunk has no length with seed 7. Raise levels[0].length, which is 0.',
      undefined,
    ]);
  });

  test('does not go on with another one that was begun in its folder', async () => {
    const out = join(folder, 'other');
    await call('bake', 'quaking-aspen', '--seeds', '1', '--format', 'none', '--out', out);
    const { status, err } = await call('bake', 'quaking-aspen', '--seeds', '2', '--format', 'none', '--out', out);
    expect(status).toBe(1);
    expect(err).toMatch(/manifest\.json: is of a bake of other species, seeds or options\. Choose another --out/);
  });
});

test('a journal that was cut off within a line keeps what comes after it', () => {
  const out = join(folder, 'journal');
  const shard = { part: 2, of: 5 };
  const tree = (index: number) => ({ index, species: 'a', seed: index, files: [] });
  new BakeJournal(out, shard, 'plan').add(tree(1));
  appendFileSync(join(out, '.bake-2-of-5.jsonl'), '{"index":6,');
  new BakeJournal(out, shard, 'plan').add(tree(11));
  expect([...new BakeJournal(out, shard, 'plan').done.keys()]).toEqual([1, 11]);
  expect(() => new BakeJournal(out, shard, 'other')).toThrow(/another bake was begun here/);
});

test.each([
  [[], 'bake takes at least one SPECIES.'],
  [['quaking-aspen'], 'bake takes --seeds, as --seeds 1..1000.'],
  [['quaking-aspen', '--seeds', '1'], 'bake takes --out DIR'],
  [['quaking-aspen', '--seeds', '5..1', '--out', 'x'], '--seeds: found "5..1"; allowed: whole numbers from 0'],
  [['quaking-aspen', '--seeds', '1..5,3', '--out', 'x'], '--seeds: found "1..5,3"'],
  [['quaking-aspen', '--seeds', '-3', '--out', 'x'], '--seeds: found "-3"'],
  [['quaking-aspen', '--seeds', '0..4294967295', '--out', 'x'], '--seeds: 4294967296 trees; allowed: up to 10000000.'],
  [
    ['quaking-aspen', '--seeds', '1', '--out', 'x', '--shard', '4/3'],
    '--shard: found "4/3"; allowed: K/N with K from 1',
  ],
  [['quaking-aspen', '--seeds', '1', '--out', 'x', '--jobs', '0'], '--jobs: found "0"; allowed: a whole number from 1'],
  [
    ['quaking-aspen', '--seeds', '1', '--out', 'x', '--format', 'fbx'],
    '--format: found the text "fbx"; allowed: glb, obj',
  ],
  [['quaking-aspen', 'quaking-aspen', '--seeds', '1', '--out', 'x'], 'There are two species "quaking-aspen"'],
  [['quaking-aspen', '--seeds', '1', '--out', 'x', '--seed', '1'], 'bake takes no --seed; allowed: --seeds'],
  [['quaking-aspen', '--merge', 'x'], 'bake --merge DIR takes nothing else.'],
])('bake %j is a wrong call', async (args, message) => {
  const { status, out, err } = await call('bake', ...args);
  expect([status, out]).toEqual([2, '']);
  expect(err).toContain(message);
});
