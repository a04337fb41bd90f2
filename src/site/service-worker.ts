// Keeps the site for when there is no network. vite.offline.config.ts builds it after all else and writes into it what is kept from the start.
import { cleanupOutdatedCaches, matchPrecache, type PrecacheEntry, precacheAndRoute } from 'workbox-precaching';
import { registerRoute, setCatchHandler } from 'workbox-routing';
import { CacheFirst, NetworkFirst, StaleWhileRevalidate, type Strategy } from 'workbox-strategies';
import { type Keeping, keepingOf } from './keeping.ts';

/** What a page says: the addresses of itself and of all that it loaded before its keeper was there. */
export interface KeepMessage {
  readonly keep: readonly string[];
}

declare const KEPT_FROM_THE_START: PrecacheEntry[];
declare const SITE_VERSION: string;
declare const self: ServiceWorkerGlobalScope;

/** Seconds that the network has for a page that is kept. */
const PATIENCE = 4;

/** One for each version of the site: what an older one kept may not fit this one's pages. */
const PREFIX = 'windgrove-seen-';
const cacheName = `${PREFIX}${SITE_VERSION}`;

const top = new URL('./', self.location.href);
const inSite = (url: URL): string | null =>
  url.origin === top.origin && url.pathname.startsWith(top.pathname) ? url.pathname.slice(top.pathname.length) : null;

/** A file whose sender says that it is not to be kept is not. */
const plugins = [
  {
    cacheWillUpdate: async ({ response }: { response: Response }): Promise<Response | null> =>
      response.status === 200 && !/no-store/.test(response.headers.get('cache-control') ?? '') ? response : null,
  },
];
/** What stands behind `?` is for the page's script: the file is the same. */
const matchOptions = { ignoreSearch: true };
const ways: Readonly<Record<Exclude<Keeping, 'never'>, Strategy>> = {
  page: new NetworkFirst({ cacheName, plugins, matchOptions, networkTimeoutSeconds: PATIENCE }),
  'for-ever': new CacheFirst({ cacheName, plugins }),
  'for-now': new StaleWhileRevalidate({ cacheName, plugins }),
};

precacheAndRoute(KEPT_FROM_THE_START, { ignoreURLParametersMatching: [/.*/] });
cleanupOutdatedCaches();
for (const [keeping, way] of Object.entries(ways)) {
  registerRoute(({ url }) => {
    const path = inSite(url);
    return path !== null && keepingOf(path) === keeping;
  }, way);
}
setCatchHandler(async ({ request }) =>
  request.mode === 'navigate' ? ((await matchPrecache('offline.html')) ?? Response.error()) : Response.error(),
);

async function keepAll(addresses: readonly string[]): Promise<void> {
  const cache = await caches.open(cacheName);
  await Promise.all(
    addresses.map(async (address) => {
      const path = inSite(new URL(address));
      if (path === null || keepingOf(path) === 'never') return;
      const request = new Request(address);
      if ((await matchPrecache(request)) || (await cache.match(request, matchOptions))) return;
      const response = await fetch(request).catch(() => null);
      const kept = response && (await plugins[0]!.cacheWillUpdate({ response }));
      if (kept) await cache.put(request, kept);
    }),
  );
}

self.addEventListener('message', (event) => {
  const { keep } = event.data as KeepMessage;
  if (Array.isArray(keep)) event.waitUntil(keepAll(keep).then(() => event.ports[0]?.postMessage('kept')));
});

// The first one takes the pages that are open; a later one waits until they are closed, for their code may still load parts of its own version.
self.addEventListener('activate', (event) => {
  const old = async (): Promise<void> => {
    const names = await caches.keys();
    await Promise.all(
      names.filter((name) => name.startsWith(PREFIX) && name !== cacheName).map((name) => caches.delete(name)),
    );
    await self.clients.claim();
  };
  event.waitUntil(old());
});
