import { posix } from 'node:path';
import type { BuiltSite } from '../../src/site/kept-files.ts';

/** A reference of a page to something else. */
interface Reference {
  readonly tag: string;
  readonly to: string;
}

/** Hosts that pages may link to: where papers are, licences, and what the library is used with. Nothing is ever loaded from them. */
const ALLOWED: readonly string[] = [
  'doi.org',
  'dl.acm.org',
  'creativecommons.org',
  'opensource.org',
  'www.w3.org',
  'github.com',
  'typedoc.org',
  'threejs.org',
  'developer.mozilla.org',
  'docs.godotengine.org',
];

/** Pages that are drawn by their scripts: what they say of themselves stands in their heads alone. */
const DRAWN: readonly string[] = ['index.html', 'forest.html', 'range.html', 'bench.html'];

/** Pages that other programs make: only their links are ours. */
const MADE = /^(?:reference\/api|source)\//;

/** Pages that nobody is led to: they stand in for others, or in frames. */
const APART: readonly string[] = ['404.html', 'offline.html', 'viewer.html'];

const plain = (text: string): string =>
  text
    .replaceAll('&amp;', '&')
    .replaceAll('&quot;', '"')
    .replace(/&#(?:39|x27);/g, "'");

const withoutCode = (html: string): string =>
  html.replace(/<!--[\s\S]*?-->/g, '').replace(/(<(script|style)\b[^>]*>)[\s\S]*?<\/\2>/g, '$1</$2>');

function referencesOf(html: string): Reference[] {
  const tags = [...html.matchAll(/<([a-z][\w-]*)\b((?:[^>"']|"[^"]*"|'[^']*')*)>/gi)];
  return tags.flatMap(([, tag, attributes]) =>
    [...attributes!.matchAll(/\s(?:href|src|poster|data-src)=(?:"([^"]*)"|'([^']*)')/g)].map(([, a, b]) => ({
      tag: tag!.toLowerCase(),
      to: plain(a ?? b ?? ''),
    })),
  );
}

const anchorsOf = (html: string): Set<string> =>
  new Set([...html.matchAll(/\s(?:id|name)=(?:"([^"]*)"|'([^']*)')/g)].map(([, a, b]) => plain(a ?? b ?? '')));

/** What is wrong with the links of a built site, and with what its pages say of themselves: a line each. */
export function siteFaults(site: BuiltSite): string[] {
  const files = new Set(site.files);
  const pages = site.files.filter((file) => file.endsWith('.html'));
  const html = new Map(pages.map((page) => [page, withoutCode(site.text(page))]));
  const anchors = new Map<string, Set<string>>();
  const anchorsIn = (page: string): Set<string> => {
    const known = anchors.get(page) ?? anchorsOf(html.get(page)!);
    anchors.set(page, known);
    return known;
  };
  const faults: string[] = [];
  const led = new Map<string, Set<string>>();
  for (const page of pages) {
    const targets = new Set<string>();
    led.set(page, targets);
    for (const { tag, to } of referencesOf(html.get(page)!)) {
      const wrong = faultOf(page, tag, to, { files, html, anchorsIn, targets });
      if (wrong) faults.push(`${page}: ${wrong}`);
    }
    if (!MADE.test(page)) faults.push(...headFaults(html.get(page)!, page).map((fault) => `${page}: ${fault}`));
  }
  const seen = new Set(['index.html']);
  for (const page of seen) for (const next of led.get(page) ?? []) seen.add(next);
  for (const page of pages)
    if (!seen.has(page) && !APART.includes(page) && !MADE.test(page))
      faults.push(`${page}: no way leads here from index.html`);
  return faults;
}

interface Around {
  readonly files: ReadonlySet<string>;
  readonly html: ReadonlyMap<string, string>;
  readonly anchorsIn: (page: string) => ReadonlySet<string>;
  readonly targets: Set<string>;
}

function faultOf(page: string, tag: string, to: string, { files, html, anchorsIn, targets }: Around): string | null {
  if (/^(?:data|mailto|blob):/.test(to)) return null;
  if (/^[a-z]+:/i.test(to) || to.startsWith('//')) {
    const host = URL.canParse(to) ? new URL(to).host : to;
    if (tag === 'a' && to.startsWith('https:') && ALLOWED.includes(host)) return null;
    return `<${tag}> asks for ${to}, which is not of this site`;
  }
  if (to.startsWith('/')) return `${to} is right only where the site stands at the top of its host`;
  const [path = '', fragment = ''] = to.split('#') as [string, string?];
  const file = path.replace(/\?.*$/, '');
  let target = file === '' ? page : posix.join(posix.dirname(page), decodeURIComponent(file));
  if (target.endsWith('/') || target === '.') target = posix.join(target, 'index.html');
  if (!files.has(target)) return `<${tag}> asks for ${to}, which is not there`;
  if (tag === 'a' && html.has(target)) targets.add(target);
  // A picture's settings stand behind # on the pages that have some.
  if (fragment === '' || fragment.includes('=') || !html.has(target)) return null;
  return anchorsIn(target).has(decodeURIComponent(fragment)) ? null : `${to}: there is no #${fragment}`;
}

function headFaults(html: string, page: string): string[] {
  const faults: string[] = [];
  const need = (what: string, pattern: RegExp): void => {
    if (!pattern.test(html)) faults.push(`has no ${what}`);
  };
  need('lang', /<html[^>]*\slang="\w/);
  need('title', /<title>[^<]*\S[^<]*<\/title>/);
  need('description', /<meta name="description" content="[^"]{20,}"/);
  need('og:title', /<meta property="og:title" content="[^"]+"/);
  need('og:image', /<meta property="og:image" content="[^"]+"/);
  need('viewport', /<meta name="viewport"/);
  const headings = html.match(/<h1\b/g)?.length ?? 0;
  if (headings > 1 || (headings === 0 && !DRAWN.includes(page)))
    faults.push(`has ${headings} headings of the first rank`);
  const image = /<meta property="og:image" content="(?!https?:)([^"]+)"/.exec(html)?.[1];
  if (image && !posix.join(posix.dirname(page), image).startsWith('cards/'))
    faults.push(`its card ${image} is no card`);
  return faults;
}
