import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';

const root = join(import.meta.dirname, '../..');
const page = readFileSync(join(root, 'docs/library.md'), 'utf8');
const blocks = [...page.matchAll(/^<!-- (\S+) -->\n```\w+\n([\s\S]*?)^```$/gm)];

it('docs/library.md shows the code of the projects that are tested, to the letter', () => {
  expect(blocks.map(([, path]) => path)).toEqual([
    'e2e/library/page/index.html',
    'e2e/library/vite/main.js',
    'e2e/library/react/main.jsx',
    'e2e/library/node/main.mjs',
  ]);
  for (const [, path, code] of blocks) expect(code, path).toBe(readFileSync(join(root, path!), 'utf8'));
});
