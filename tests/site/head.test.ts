import { existsSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { navigation } from '../../build/site.ts';
import { CARDS } from '../../src/site/cards.ts';
import { headTags, wayUp } from '../../src/site/head.ts';
import { SITE_PAGES } from '../../src/site/pages.ts';

const root = join(import.meta.dirname, '../..');
const page = { title: 'Range', description: 'What is left of a tree.', siteUrl: null, hasIcon: false, keep: true };
const valuesOf = (tags: ReturnType<typeof headTags>) =>
  Object.fromEntries(
    tags.map(({ attrs: a }) => [a.property ?? a.rel ?? a.name ?? a.type, a.content ?? a.href ?? a.src]),
  );

it('says where the card, the icon and the keeper are, seen from the page', () => {
  expect(valuesOf(headTags({ ...page, page: 'learn/range.html' }))).toMatchObject({
    'og:title': 'Range',
    'og:description': 'What is left of a tree.',
    'og:image': '../cards/learn.jpg',
    icon: '../icon.svg',
    manifest: '../manifest.webmanifest',
    module: '../keep.js',
  });
});

it('gives whole addresses where it is told where the site will stand', () => {
  const tags = valuesOf(headTags({ ...page, page: 'learn/index.html', siteUrl: 'https://example.org/w/' }));
  expect(tags).toMatchObject({
    'og:image': 'https://example.org/w/cards/learn.jpg',
    'og:url': 'https://example.org/w/learn/',
    canonical: 'https://example.org/w/learn/',
    manifest: '../manifest.webmanifest',
  });
});

it('keeps nothing because of a page in a frame, or in place of one that is missing', () => {
  for (const passing of ['viewer.html', '404.html', 'offline.html'])
    expect(valuesOf(headTags({ ...page, page: passing }))).not.toHaveProperty('module');
});

it('has every card, below what programs that unfold links put up with', () => {
  for (const { file } of Object.values(CARDS)) {
    expect(existsSync(join(root, 'public', file)), file).toBe(true);
    expect(statSync(join(root, 'public', file)).size, file).toBeLessThan(150_000);
  }
});

it('leads from any depth to every page, and marks the one where the reader is', () => {
  expect(wayUp('reference/api/x.html')).toBe('../../');
  const nav = navigation('learn', 1);
  for (const { href } of SITE_PAGES) expect(nav).toContain(`href="../${href}"`);
  expect(nav.match(/aria-current="page"/g)).toHaveLength(1);
  expect(nav).toMatch(/learn\/index\.html"[^>]*aria-current/);
});
