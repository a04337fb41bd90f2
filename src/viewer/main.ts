import '../element/define.ts';
import type { WindTreeElement } from '../element/wind-tree-element.ts';
import { converse } from './converse.ts';
import { editorLink } from './editor-link.ts';
import { readAddress, VIEWER_ATTRIBUTES } from './read-address.ts';
import { words } from './words.ts';

/** The tree of the page's address; built anew where only what stands behind `#` changes. */
function show(place: HTMLElement): void {
  const { attributes, link, origins, faults } = readAddress(location.search, location.hash);
  for (const fault of faults) console.warn(fault);
  const tree = document.createElement('wind-tree') as WindTreeElement;
  // The page is nothing but the tree: there is nothing to wait for.
  tree.setAttribute('loading', 'eager');
  for (const [name, value] of attributes) tree.setAttribute(name, value);
  const made = place.querySelector<HTMLAnchorElement>('.made')!;
  made.hash = link ?? editorLink(attributes);
  const stand = (): void => place.prepend(tree);
  tree.addEventListener('load', () => {
    document.documentElement.dataset.ready = 'true';
  });
  const host = window.parent === window ? (window.opener as Window | null) : window.parent;
  converse(tree, { source: host, origins }, VIEWER_ATTRIBUTES);
  if (link === null) stand();
  else void follow(tree, link, attributes).then(stand, (error: unknown) => fail(place, error));
}

/** Has the element show what a link of the editor means; attributes that stand beside it go before. */
async function follow(tree: WindTreeElement, link: string, attributes: ReadonlyMap<string, string>): Promise<void> {
  const { shownByLink } = await import('./shown-by-link.ts');
  const { species, wind, document: linked, environment, debug, leftOut, faults } = await shownByLink(link);
  for (const { key, found, allowed } of faults) console.warn(`${key}: found "${found}"; allowed: ${allowed}.`);
  if (leftOut.length > 0) console.warn(words.leftOut(leftOut));
  const { seed, season, rate, time, paused, camera, theme, hour, levelsShown, showLeaves } = linked;
  if (theme !== 'auto') document.documentElement.dataset.theme = theme;
  tree.speciesData = species;
  tree.windData = wind;
  tree.seed = seed;
  tree.season = season;
  tree.playbackRate = rate;
  if (!attributes.has('environment')) tree.environment = environment;
  if (!attributes.has('debug')) tree.debug = debug;
  tree.hour = hour;
  tree.levels = levelsShown;
  tree.leaves = showLeaves;
  tree.setState({
    ...(attributes.has('time') ? {} : { time }),
    paused: paused || tree.paused,
    ...(camera ? { camera } : {}),
  });
}

function fail(place: HTMLElement, error: unknown): void {
  const said = document.createElement('p');
  said.className = 'failed';
  said.setAttribute('role', 'alert');
  said.textContent = words.failed(error instanceof Error ? error.message : String(error));
  place.prepend(said);
}

show(document.querySelector('main')!);
// A page that frames the viewer may change its address behind `#`, and a reader may edit it.
addEventListener('hashchange', () => location.reload());
