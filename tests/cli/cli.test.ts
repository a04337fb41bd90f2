import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { run } from '../../src/cli/run.ts';
import type { TreeStats } from '../../src/core/grow/stats.ts';

const root = join(import.meta.dirname, '../..');
const aspen = join(root, 'public/species/quaking-aspen.json');
let folder = '';
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'windgrove-'));
});
afterAll(() => rmSync(folder, { recursive: true }));

async function call(...args: string[]): Promise<{ status: number; out: string; err: string }> {
  const out: string[] = [];
  const err: string[] = [];
  const status = await run(args, { out: (line) => out.push(line), err: (line) => err.push(line) });
  return { status, out: out.join('\n'), err: err.join('\n') };
}

function file(name: string, change: (species: Record<string, never>) => unknown): string {
  const species = JSON.parse(readFileSync(aspen, 'utf8'));
  const path = join(folder, name);
  const text = change(species);
  writeFileSync(path, typeof text === 'string' ? text : JSON.stringify(species));
  return path;
}

describe('stats', () => {
  test('prints the figures as JSON', async () => {
    const { status, out, err } = await call('stats', 'quaking-aspen', '--seed', '4', '--json');
    expect([status, err]).toEqual([0, '']);
    const stats = JSON.parse(out) as TreeStats;
    expect(Object.keys(stats)).toEqual([
      'species',
      'seed',
      'height',
      'radius',
      'levels',
      'leaves',
      'pieces',
      'maxDepth',
      'bytes',
      'milliseconds',
    ]);
    expect(Object.keys(stats.levels[1])).toEqual([
      'level',
      'stems',
      'clones',
      'segments',
      'pieces',
      'length',
      'baseRadius',
      'declinationDeg',
    ]);
    expect(stats).toMatchObject({ species: 'Quaking Aspen', seed: 4 });
    expect(stats.levels.map(({ level, stems }) => [level, stems]).slice(0, 2)).toEqual([
      [0, 1],
      [1, 30],
    ]);
    expect(stats.bytes).toBeGreaterThan(10_000);
    expect(stats.milliseconds).toBeGreaterThan(0);
  });

  test('prints the same figures to read, for a file too, with seed 1 where none is given', async () => {
    const { status, out } = await call('stats', aspen);
    const stats = JSON.parse((await call('stats', 'Quaking-Aspen', '--seed', '1', '--json')).out) as TreeStats;
    expect(status).toBe(0);
    expect(out).toContain('Quaking Aspen, seed 1');
    expect(out).toContain(`height ${stats.height.toFixed(2)} m`);
    expect(out).toContain(`${stats.leaves} leaves, ${stats.pieces} pieces`);
  });

  test('a tree beyond the budget ends with its message', async () => {
    const huge = file('huge.json', ({ levels }: Record<string, { branches: number }[]>) => {
      levels[1].branches = 50_000;
      levels[2].branches = 50_000;
    });
    const { status, out, err } = await call('stats', huge);
    expect([status, out]).toEqual([1, '']);
    expect(err).toMatch(/asks for at least .* stems; the limit is 400\u2009000.*levels\[2\]\.branches/);
  });

  test('a tree without a trunk ends with what to change', async () => {
    const flat = file('flat.json', ({ levels }: Record<string, { length: number }[]>) => {
      levels[0].length = 0;
    });
    expect(await call('stats', flat)).toEqual({
      status: 1,
      out: '',
      err: 'The trunk has no length with seed 1. Raise levels[0].length, which is 0.',
    });
  });

  test.each([
    [['stats', 'aspen'], 1, 'Did you mean quaking-aspen?'],
    [['stats', 'black-tulepo'], 1, 'Did you mean black-tupelo?'],
    [['stats', 'no/such.json'], 1, 'no/such.json: there is no such file.'],
    [['stats', root], 1, 'is a folder'],
    [['stats'], 2, 'stats takes one SPECIES'],
    [['stats', 'a', 'b'], 2, 'stats takes one SPECIES'],
    [['stats', 'quaking-aspen', '--seed', 'x'], 2, '--seed: found "x"; allowed: a whole number from 0 to 4294967295.'],
    [['stats', 'quaking-aspen', '--seed', '4294967296'], 2, '--seed: found'],
    [
      ['stats', 'quaking-aspen', '--seed', '-1'],
      2,
      '--seed: found "-1"; allowed: a whole number from 0 to 4294967295.',
    ],
    [['stats', 'quaking-aspen', '--sead', '1'], 2, '--sead'],
    [['validate'], 2, 'validate takes at least one FILE'],
    [['validate', aspen, '--json'], 2, 'validate takes no options'],
    [['plant'], 2, 'There is no command "plant"'],
    [[], 2, 'Say what to do'],
  ])('%j ends with %i', async (args, status, message) => {
    const result = await call(...args);
    expect(result).toMatchObject({ status, out: '' });
    expect(result.err).toContain(message);
  });
});

describe('validate', () => {
  test('says of each file whether it is valid', async () => {
    const others = ['black-tupelo', 'weeping-willow', 'california-black-oak'].map((name) =>
      join(root, `public/species/${name}.json`),
    );
    const { status, out, err } = await call('validate', aspen, ...others);
    expect([status, err]).toEqual([0, '']);
    expect(out.split('\n')).toEqual([aspen, ...others].map((path) => `${path}: a valid species`));
  });

  test('tells winds and lists from species by what they say of themselves', async () => {
    const files = ['winds/recorded.json', 'winds/index.json', 'species/index.json'].map((name) =>
      join(root, 'public', name),
    );
    const { status, out, err } = await call('validate', ...files);
    expect([status, err]).toEqual([0, '']);
    expect(out.split('\n')).toEqual([
      `${files[0]}: a valid wind`,
      expect.stringMatching(/winds\/index\.json: a valid list of \d\d files$/),
      expect.stringMatching(/species\/index\.json: a valid list of \d\d files$/),
    ]);
  });

  test('finds the faults of a wind, of the record beside it, and of a list', async () => {
    const write = (name: string, value: unknown): string => {
      writeFileSync(join(folder, name), typeof value === 'string' ? value : JSON.stringify(value));
      return join(folder, name);
    };
    const wind = { format: 'windgrove-wind', version: 1, name: 'Mine' };
    write('mast.csv', 'time,speed\n0,4\n1,fast\n');
    const files = [
      write('waves.json', { ...wind, waves: [{ wavelength: 0 }] }),
      write('recorded.json', { ...wind, record: 'mast.csv' }),
      write('lost.json', { ...wind, record: 'lost.csv' }),
      write('list.json', [{ id: 'a', name: 'A', file: 'none.json' }]),
      write('other.json', { format: 'windgrove-tree' }),
      write('number.json', '7'),
    ];
    const { status, out, err } = await call('validate', ...files);
    expect([status, out]).toEqual([1, '']);
    const at = (i: number): string => `${files[i]}: `;
    expect(err.split('\n')).toEqual([
      `${at(0)}waves[0].wavelength: found 0; allowed: a number from 0.1 to 500 metres.`,
      `${at(1)}mast.csv, line 3, speed: found the text "fast"; allowed: a number from 0 to 100, or nothing.`,
      `${join(folder, 'lost.csv')}: there is no such file.`,
      `${at(3)}[0].file: found the text "none.json"; allowed: the name of a file beside this one.`,
      `${at(4)}format: found the text "windgrove-tree"; allowed: "windgrove-species" or "windgrove-wind".`,
      `${at(5)}The file: found 7; allowed: "windgrove-species" or "windgrove-wind".`,
    ]);
  });

  test('names the path of every fault and ends with 1', async () => {
    const bad = file('bad.json', ({ tree, levels }: Record<string, never>) => {
      Object.assign(tree, { scale: 'tall' });
      Object.assign(levels[1], { curveRes: -1, colour: 'red' });
    });
    const broken = file('broken.json', () => '{"format": ');
    const { status, out, err } = await call('validate', bad, aspen, broken, join(folder, 'none.json'));
    expect(status).toBe(1);
    expect(out).toBe(`${aspen}: a valid species`);
    expect(err.split('\n')).toEqual([
      `${bad}: tree.scale: found the text "tall"; allowed: a number from 0.05 to 150 metres.`,
      expect.stringContaining(`${bad}: levels[1].colour: found an unknown key`),
      `${bad}: levels[1].curveRes: found -1; allowed: a whole number from 1 to 200.`,
      expect.stringMatching(/broken\.json: The file: found broken JSON/),
      expect.stringMatching(/none\.json: there is no such file\.$/),
    ]);
  });
});

test('--help and --version', async () => {
  for (const args of [['--help'], ['-h'], ['help'], ['stats', '--help']]) {
    expect(await call(...args)).toMatchObject({ status: 0, err: '' });
    expect((await call(...args)).out).toContain('windgrove validate FILE...');
  }
  const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  expect(await call('--version')).toEqual({ status: 0, out: version, err: '' });
});

test('the file itself runs in Node and hands on the exit status', async () => {
  const main = join(root, 'src/cli/main.ts');
  const node = (...args: string[]) =>
    execFileSync(process.execPath, ['--import', 'tsx', main, ...args], { cwd: root, stdio: 'pipe' });
  expect(node('validate', aspen).toString()).toContain('a valid species');
  expect(() => node('stats', 'nothing')).toThrow(expect.objectContaining({ status: 1 }));
}, 30_000);

test('a reader that goes away early, as head does, gets no stack trace', async () => {
  const child = spawn(process.execPath, ['--import', 'tsx', join(root, 'src/cli/main.ts'), 'validate', aspen], {
    cwd: root,
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  child.stdout.destroy();
  let complaint = '';
  child.stderr.on('data', (data) => {
    complaint += data;
  });
  const status = await new Promise((done) => child.on('close', done));
  expect([status, complaint]).toEqual([0, '']);
}, 30_000);
