/** How what is asked of the site is answered when it is not among what is kept from the start. */
export type Keeping = 'page' | 'for-ever' | 'for-now' | 'never';

const PICTURES_AND_DATA = /\.(?:webp|svg|png|jpg|json|csv|woff2|css|js|webmanifest)$/;

/**
 * What becomes of the file at `path`, seen from the top of the site.
 *
 * `page`: from the network, and as it was last where there is none. `for-ever`: its name says its content. `for-now`: as it was last, and from the
 * network for the next time. `never`: not of the site, or something that a page made, such as a benchmark's result.
 */
export function keepingOf(path: string): Keeping {
  if (path === '' || path.endsWith('/') || path.endsWith('.html')) return 'page';
  if (path === 'service-worker.js') return 'never';
  if (/^assets\/.*-[\w-]{8}\.\w+$/.test(path)) return 'for-ever';
  return PICTURES_AND_DATA.test(path) ? 'for-now' : 'never';
}
