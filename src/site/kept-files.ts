/** A built site, as its files. */
export interface BuiltSite {
  /** Paths of all files, seen from the top. */
  readonly files: readonly string[];
  text(path: string): string;
}

const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

/** The files of `assets/` that a page loads at once or later: those whose names stand in it, and in what it loads. */
export function reach({ files, text }: BuiltSite, page: string): string[] {
  const assets = files.filter((file) => file.startsWith('assets/'));
  const found = new Set<string>();
  const waiting = [page];
  for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
    if (!/\.(?:html|js|css)$/.test(next)) continue;
    const code = text(next);
    for (const asset of assets) {
      if (found.has(asset) || !code.includes(nameOf(asset))) continue;
      found.add(asset);
      waiting.push(asset);
    }
  }
  return [...found].sort();
}

const DATA = /^(?:species|winds|forests)\/[\w.-]+\.(?:json|csv|svg)$/;
const PLAIN: readonly string[] = ['icon.svg', 'manifest.webmanifest', 'icons/icon-192.png'];
const PAGES: readonly string[] = ['index.html', 'viewer.html', 'offline.html'];

/** Not needed to use the page: descriptions of the files for programs that write them. */
const SCHEMA = /\.schema\.json$/;

/**
 * What is kept from the first visit on: the editor with all that it loads later, the viewer's page, and every species, wind and scene of a forest.
 *
 * Portraits, help pictures, lessons and the other pages are kept when they have been seen.
 */
export function keptFromTheStart(site: BuiltSite): string[] {
  const { files } = site;
  const pages = PAGES.filter((page) => files.includes(page));
  const code = pages.flatMap((page) => reach(site, page));
  const data = files.filter((file) => (DATA.test(file) && !SCHEMA.test(file)) || PLAIN.includes(file));
  return [...new Set([...pages, ...code, ...data])].sort();
}
