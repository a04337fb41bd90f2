// On every page of the built site, after all else: has the page kept for when there is no network.
import type { KeepMessage } from './service-worker.ts';

/** Milliseconds after which the page counts as settled though it never rests, as one that draws all the time. */
const SETTLED = 8000;

const here = import.meta.url;
const { connection } = navigator as Navigator & { readonly connection?: { readonly saveData?: boolean } };

/** The page and all that it loaded until now: it was there before its keeper. */
const loaded = (): string[] => [
  location.href.replace(/#.*/, ''),
  ...performance.getEntriesByType('resource').map(({ name }) => name),
];

async function keep(): Promise<void> {
  // Named so that the bundler leaves the addresses alone: these files keep their names, at the top of the site.
  await navigator.serviceWorker.register(new URL('service-worker.js', here), { scope: new URL('./', here).pathname });
  const { active } = await navigator.serviceWorker.ready;
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => {
    document.documentElement.dataset.kept = 'true';
  };
  active?.postMessage({ keep: loaded() } satisfies KeepMessage, [port2]);
}

/** Not while the page is busy with what it was opened for. */
const whenSettled = (work: () => void): void => {
  if ('requestIdleCallback' in window) requestIdleCallback(work, { timeout: SETTLED });
  else setTimeout(work, SETTLED);
};

// A browser that refuses (a private window, a page without TLS) shows the page as well; it only keeps nothing.
const begin = (): void => whenSettled(() => void keep().catch(() => undefined));
if ('serviceWorker' in navigator && !connection?.saveData) {
  if (document.readyState === 'complete') begin();
  else addEventListener('load', begin);
}
