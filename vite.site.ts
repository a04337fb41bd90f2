import type { Plugin } from 'vite';
import { SITE_PAGES } from './src/site/pages.ts';

/** Where a page asks for the navigation: `<wg-nav current="learn"></wg-nav>`, `current` being the id of its part of the site. */
const PLACE = /<wg-nav(?: current="([\w-]*)")?>\s*<\/wg-nav>/;

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

/** The navigation as it stands in a page `depth` folders below the top of the site. */
export function navigation(current: string, depth: number): string {
  const up = '../'.repeat(depth) || './';
  const links = SITE_PAGES.map(({ id, name, about, href }) => {
    const here = id === current ? ' aria-current="page"' : '';
    return `<a href="${up}${href}" title="${escaped(about)}"${here}>${escaped(name)}</a>`;
  });
  return `<nav class="site" aria-label="Windgrove"><a class="home" href="${up}index.html">Windgrove</a>${links.join('')}</nav>`;
}

/** Writes the navigation into every page that has a place for it; it is there without JavaScript. */
export function site(): Plugin {
  return {
    name: 'windgrove:site',
    transformIndexHtml: {
      order: 'pre',
      handler(html, { path }) {
        const depth = path.replace(/^\//, '').split('/').length - 1;
        return html.replace(PLACE, (_, current: string | undefined) => navigation(current ?? '', depth));
      },
    },
  };
}
