import { existsSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import type { Plugin } from 'vite';
import { headTags } from '../src/site/head.ts';
import { SITE_PAGES } from '../src/site/pages.ts';

/** Where a page asks for the navigation: `<wg-nav current="learn"></wg-nav>`, `current` being the id of its part of the site. */
const PLACE = /<wg-nav(?: current="([\w-]*)")?>\s*<\/wg-nav>/;

/** Folders whose pages are of no site: what browser tests and the makers of pictures look at. */
const APART = /^(?:e2e|docs)\//;

/** Where a page asks for all pages, one below the other. */
const ALL = '<wg-pages></wg-pages>';

/** Where a page that is shown at addresses of any depth asks for its style and its script, which stand in it. */
const STRAY = /<wg-stray part="(style|script)"><\/wg-stray>/g;

const textOf = (file: string): string => readFileSync(resolve(import.meta.dirname, '../src/site', file), 'utf8');

const stray = (part: string): string =>
  part === 'style'
    ? `<style>\n${textOf('tokens.css')}${textOf('stray.css')}</style>`
    : `<script>\n${textOf('stray.js')}</script>`;

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

const plain = (text: string): string =>
  text.replaceAll('&amp;', '&').replaceAll('&lt;', '<').replaceAll('&quot;', '"').replace(/\s+/g, ' ').trim();

/** The navigation as it stands in a page `depth` folders below the top of the site. */
export function navigation(current: string, depth: number): string {
  const up = '../'.repeat(depth) || './';
  const links = SITE_PAGES.map(({ id, name, short = name, about, href }) => {
    const here = id === current ? ' aria-current="page"' : '';
    return `<a href="${up}${href}" title="${escaped(about)}"${here}>${escaped(short)}</a>`;
  });
  return `<nav class="site" aria-label="Windgrove"><a class="home" href="${up}index.html">Windgrove</a>${links.join('')}</nav>`;
}

/** All pages, for one at the top of the site. */
const allPages = (): string =>
  `<nav aria-label="Windgrove">${SITE_PAGES.map(({ name, href }) => `<a href="./${href}">${escaped(name)}</a>`).join('')}</nav>`;

/**
 * `SITE_URL=https://example.org/windgrove/ npm run build`: where the site will stand. Every link of it is relative and needs no such thing; programs
 * that unfold links into cards do.
 */
function siteUrl(): string | null {
  const given = process.env.SITE_URL;
  if (!given) return null;
  const url = new URL(given);
  return url.href.endsWith('/') ? url.href : `${url.href}/`;
}

/** Writes the navigation into every page that has a place for it, and what the page says of itself into its head; both are there without JavaScript. */
export function site(): Plugin[] {
  const fileOf = (path: string): string => path.replace(/^\//, '');
  return [
    {
      name: 'windgrove:navigation',
      /** As hosts do: 404.html for what there is not. */
      configurePreviewServer({ config, middlewares }) {
        const out = resolve(config.root, config.build.outDir);
        return () => {
          middlewares.use((request, response, next) => {
            const path = join(out, new URL(request.url ?? '/', 'http://host/').pathname);
            if (existsSync(path) || existsSync(`${path}.html`)) return next();
            response.writeHead(404, { 'content-type': 'text/html' });
            response.end(readFileSync(join(out, '404.html')));
          });
        };
      },
      transformIndexHtml: {
        order: 'pre',
        handler(html, { path }) {
          const depth = fileOf(path).split('/').length - 1;
          return html
            .replace(PLACE, (_, current: string | undefined) => navigation(current ?? '', depth))
            .replace(ALL, allPages)
            .replace(STRAY, (_, part: string) => stray(part));
        },
      },
    },
    {
      name: 'windgrove:head',
      // After the bundler: these files stand in public/ and keep their names.
      transformIndexHtml: {
        order: 'post',
        handler(html, { path, server }) {
          const page = fileOf(path);
          if (APART.test(page)) return;
          const title = plain(/<title>([^<]*)<\/title>/.exec(html)?.[1] ?? '');
          const description = plain(/<meta\s+name="description"\s+content="([^"]*)"/.exec(html)?.[1] ?? '');
          const hasIcon = /<link[^>]*\srel="icon"/.test(html);
          const tags = headTags({ page, title, description, siteUrl: siteUrl(), hasIcon, keep: !server });
          return tags.map(({ tag, attrs }) => ({ tag, attrs: { ...attrs }, injectTo: 'head' as const }));
        },
      },
    },
  ];
}
