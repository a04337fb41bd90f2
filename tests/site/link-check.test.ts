import { expect, it } from 'vitest';
import { siteFaults } from './link-check.ts';

const head = (more = ''): string =>
  `<html lang="en"><head><title>A page</title><meta name="viewport" content="x"><meta name="description" content="Something long enough to be one.">
  <meta property="og:title" content="A page"><meta property="og:image" content="${more || './'}cards/site.jpg"></head>`;
const site = (pages: Readonly<Record<string, string>>) => ({
  files: [...Object.keys(pages), 'assets/a.css', 'cards/site.jpg'],
  text: (path: string) => pages[path]!,
});
const good = {
  'index.html': `${head()}<h1>A</h1><a href="./learn/index.html#two">b</a><a href='#top' id=top></a><link href="./assets/a.css"><a href="?x=1#s=oak&amp;seed=3">c</a><p id="top">`,
  'learn/index.html': `${head('../')}<h1>B</h1><p id="two"><a href="../">home</a><a href="https://doi.org/10.1145/1">paper</a><img src="data:image/png;base64,A">`,
};

it('finds nothing wrong with a site whose links all lead somewhere', () => {
  expect(siteFaults(site(good))).toEqual([]);
});

it.each([
  ['a page that is missing', '<a href="./none.html">', 'index.html: <a> asks for ./none.html, which is not there'],
  ['an anchor that is missing', '<a href="learn/#three">', 'index.html: learn/#three: there is no #three'],
  [
    'an address from the top of the host',
    '<a href="/learn/">',
    'index.html: /learn/ is right only where the site stands at the top of its host',
  ],
  [
    'a script from elsewhere',
    '<script src="https://doi.org/a.js"></script>',
    'index.html: <script> asks for https://doi.org/a.js, which is not of this site',
  ],
  [
    'a link to a host nobody knows',
    '<a href="https://example.org">',
    'index.html: <a> asks for https://example.org, which is not of this site',
  ],
  ['a second heading', '<h1>Again</h1>', 'index.html: has 2 headings of the first rank'],
])('finds %s', (_, html, fault) => {
  expect(siteFaults(site({ ...good, 'index.html': good['index.html'] + html }))).toEqual([fault]);
});

it('finds a page that nothing leads to, and one that says nothing of itself', () => {
  expect(siteFaults(site({ ...good, 'lost.html': `${head()}<h1>C</h1>` }))).toEqual([
    'lost.html: no way leads here from index.html',
  ]);
  const bare = good['learn/index.html'].replace(/<meta property="og:image"[^>]*>/, '').replace(' lang="en"', '');
  expect(siteFaults(site({ ...good, 'learn/index.html': bare }))).toEqual([
    'learn/index.html: has no lang',
    'learn/index.html: has no og:image',
  ]);
});
