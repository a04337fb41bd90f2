import { CARD_HEIGHT, CARD_WIDTH, cardOf } from './cards.ts';

/** A tag that goes into a page's head. */
export interface HeadTag {
  readonly tag: 'meta' | 'link' | 'script';
  readonly attrs: Readonly<Record<string, string>>;
}

export interface HeadOptions {
  /** The page's address, seen from the top of the site: `learn/range.html`. */
  readonly page: string;
  readonly title: string;
  readonly description: string;
  /** Where the site will stand, with the slash at its end. Programs that unfold links ask for whole addresses; null: only relative ones are known. */
  readonly siteUrl: string | null;
  /** The page has an icon of its own. */
  readonly hasIcon: boolean;
  /** The page is built, and is kept for when there is no network. */
  readonly keep: boolean;
}

/** The way from a page to the top of the site: `./`, `../`, ... */
export const wayUp = (page: string): string => '../'.repeat(page.split('/').length - 1) || './';

/** Pages that stand in other people's pages, or in place of one that is missing: nothing is kept because of them. */
const PASSING: readonly string[] = ['viewer.html', '404.html', 'offline.html'];

/** What every page says of itself to browsers and to programs that unfold links. */
export function headTags({ page, title, description, siteUrl, hasIcon, keep }: HeadOptions): HeadTag[] {
  const up = wayUp(page);
  const card = cardOf(page);
  const meta = (property: string, content: string): HeadTag => ({ tag: 'meta', attrs: { property, content } });
  const link = (rel: string, href: string, more = {}): HeadTag => ({ tag: 'link', attrs: { rel, href, ...more } });
  const tags = [
    meta('og:site_name', 'Windgrove'),
    meta('og:type', 'website'),
    meta('og:title', title),
    meta('og:description', description),
    meta('og:image', `${siteUrl ?? up}${card.file}`),
    meta('og:image:width', String(CARD_WIDTH)),
    meta('og:image:height', String(CARD_HEIGHT)),
    meta('og:image:alt', card.alt),
    { tag: 'meta', attrs: { name: 'twitter:card', content: 'summary_large_image' } } as const,
  ];
  if (siteUrl) {
    const address = `${siteUrl}${page.replace(/(^|\/)index\.html$/, '$1')}`;
    tags.push(meta('og:url', address), link('canonical', address));
  }
  if (!hasIcon) tags.push(link('icon', `${up}icon.svg`, { type: 'image/svg+xml' }));
  if (PASSING.includes(page)) return tags;
  tags.push(
    link('manifest', `${up}manifest.webmanifest`),
    link('apple-touch-icon', `${up}icons/icon-180.png`),
    ...(['light', 'dark'] as const).map((scheme): HeadTag => {
      const content = scheme === 'light' ? '#fbfaf6' : '#10151a';
      return { tag: 'meta', attrs: { name: 'theme-color', content, media: `(prefers-color-scheme: ${scheme})` } };
    }),
  );
  if (keep) tags.push({ tag: 'script', attrs: { type: 'module', src: `${up}keep.js` } });
  return tags;
}
