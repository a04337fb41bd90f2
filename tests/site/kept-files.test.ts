import { expect, it } from 'vitest';
import { keepingOf } from '../../src/site/keeping.ts';
import { keptFromTheStart, reach } from '../../src/site/kept-files.ts';

const code: Readonly<Record<string, string>> = {
  'index.html': '<script src="./assets/index-aaaaaaaa.js">',
  'bench.html': '<script src="./assets/bench-bbbbbbbb.js">',
  'offline.html': '',
  'assets/index-aaaaaaaa.js': 'import("./dialog-cccccccc.js");new Worker("grow-dddddddd.js")',
  'assets/dialog-cccccccc.js': '"assets/dialog-eeeeeeee.css"',
  'assets/grow-dddddddd.js': 'x',
  'assets/dialog-eeeeeeee.css': '',
  'assets/bench-bbbbbbbb.js': 'import"./index-aaaaaaaa.js"',
};
const site = {
  files: [
    ...Object.keys(code),
    'species/oak.json',
    'species/species.schema.json',
    'species/portraits/oak.webp',
    'winds/breeze.json',
    'winds/breeze.svg',
    'winds/sample.csv',
  ],
  text: (path: string) => code[path] ?? '',
};

it('finds all that a page loads now or later, and nothing of other pages', () => {
  expect(reach(site, 'index.html')).toEqual([
    'assets/dialog-cccccccc.js',
    'assets/dialog-eeeeeeee.css',
    'assets/grow-dddddddd.js',
    'assets/index-aaaaaaaa.js',
  ]);
});

it('keeps the editor, species and winds from the start, and neither portraits nor the benchmark', () => {
  const kept = keptFromTheStart(site);
  expect(kept).toEqual(
    expect.arrayContaining([
      'index.html',
      'offline.html',
      'assets/dialog-eeeeeeee.css',
      'species/oak.json',
      'winds/sample.csv',
    ]),
  );
  expect(kept.filter((file) => /bench|portraits|schema/.test(file))).toEqual([]);
});

it.each([
  ['learn/range.html', 'page'],
  ['', 'page'],
  ['assets/three.core-BWmBip8E.js', 'for-ever'],
  ['assets/katex-B_1x-9aZ.woff2', 'for-ever'],
  ['species/portraits/oak.webp', 'for-now'],
  ['winds/breeze.json', 'for-now'],
  ['service-worker.js', 'never'],
  ['bench/results.md', 'never'],
  ['report', 'never'],
] as const)('%s is kept: %s', (path, keeping) => expect(keepingOf(path)).toBe(keeping));
