import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { PARAMETERS } from '../../src/core/species/parameters.ts';
import { WIND_PARTS } from '../../src/core/wind/wind-parameters.ts';
import { elementPage } from '../../src/reference/element-page.ts';
import { pathOf } from '../../src/reference/parameter-entry.ts';
import { parametersPage } from '../../src/reference/parameters-page.ts';
import { plainMarkdown } from '../../src/reference/plain-markdown.ts';
import { windPage } from '../../src/reference/wind-page.ts';

const idsOf = (html: string): string[] => [...html.matchAll(/\sid="([^"]+)"/g)].map(([, id]) => id!);

it('has an entry for every parameter of a species, each with an anchor that no other has', () => {
  const pair = { value: '3', link: 's=oak' };
  const html = parametersPage(new Map([['tree.flare', { name: 'tree.flare', low: pair, high: pair }]]));
  const ids = idsOf(html);
  expect(new Set(ids).size).toBe(ids.length);
  expect(PARAMETERS.map(pathOf).filter((path) => !ids.includes(path))).toEqual([]);
  expect(html).toContain('<a href="../index.html#s=oak"');
  expect(html).toContain('src="../help/tree.flare-high.webp"');
});

it('has an entry for every parameter of a wind, and says how measured winds are read', () => {
  const ids = idsOf(windPage());
  expect(new Set(ids).size).toBe(ids.length);
  for (const { parameters } of Object.values(WIND_PARTS)) for (const p of parameters) expect(ids).toContain(pathOf(p));
  expect(windPage()).toContain('timestamp');
});

it('writes what docs/ is written in as HTML, and never lets text be markup', () => {
  expect(plainMarkdown('## A *b* `c<d>`\n\nOne\ntwo [x](y.md) **s**.\n\n- a\n  b\n- c')).toBe(
    '<h2 id="a-b-cd">A <em>b</em> <code>c&lt;d&gt;</code></h2>\n<p>One two <a href="y.md">x</a> <strong>s</strong>.</p>\n<ul><li>a b</li><li>c</li></ul>',
  );
  expect(plainMarkdown('| a | b |\n|---|---:|\n| `x\\|y` | 2 |')).toContain(
    '<td><code>x|y</code></td><td class="number">2</td>',
  );
  expect(plainMarkdown('```js\nif (a < b) `c`;\n```')).toBe(
    '<pre tabindex="0"><code>if (a &lt; b) `c`;\n</code></pre>',
  );
  expect(plainMarkdown('<script>alert(1)</script>')).not.toContain('<script');
});

it('leaves no Markdown over in any page of docs/ that it shows', () => {
  for (const name of ['glb.md', 'wind-channels.md', 'imports.md', 'embedding.md']) {
    const html = plainMarkdown(readFileSync(join(import.meta.dirname, '../../docs', name), 'utf8'));
    const text = html.replace(/<pre[\s\S]*?<\/pre>|<code>[\s\S]*?<\/code>/g, '').replace(/<[^>]*>/g, '');
    expect(text, name).not.toMatch(/\*\*|`|^#|\]\(|^\|/m);
  }
});

it('has a row for each thing of the element that is said of it, and none for what is private', () => {
  const html = elementPage({
    modules: [
      {
        declarations: [
          {
            tagName: 'wind-tree',
            attributes: [{ name: 'seed', type: { text: 'number' }, default: '1', description: 'Which tree.' }],
            members: [
              {
                kind: 'method',
                name: 'seek',
                parameters: [{ name: 's', type: { text: 'number' } }],
                return: { type: { text: 'void' } },
                description: 'Goes.',
              },
              { kind: 'method', name: 'secret', privacy: 'private', description: 'No.' },
            ],
            events: [{ name: 'load', description: 'It `stands`.' }],
          },
        ],
      },
    ],
  });
  expect(html).toContain('<code>seek(s: number): void</code>');
  expect(html).toContain('id="attributes-seed"');
  expect(html).toContain('It <code>stands</code>.');
  expect(html).not.toContain('secret');
});
