import { oneLine } from '../core/file/one-line.ts';
import type { ForestCamera, ForestDocument } from '../core/forest/forest.ts';
import { decodeForest, encodeForest } from '../core/forest/forest-link.ts';
import type { Sources } from './sources.ts';
import type { Notice } from './store.ts';
import { words } from './words.ts';

/** Lines that a message about a link has at most. */
const LISTED = 6;

/** The forest that the address of the page holds, null where it holds none; and what is to be said of it. */
export function readAddress(
  sources: Sources,
  fallback: ForestDocument,
): { document: ForestDocument; notice: Notice | null } | null {
  const link = location.hash.replace(/^#/, '');
  if (link === '') return null;
  const scene = sources.scenes.find(({ id }) => link === id);
  if (scene) return { document: scene.document, notice: null };
  // A link without a name is none of the scenes, even where it leaves everything else to one.
  const { document, faults, missing } = decodeForest(link, { ...fallback, name: words.own }, sources.known);
  const lines = faults
    .slice(0, LISTED)
    .map(({ key, found, allowed }) => words.fault(oneLine(key), oneLine(found, 60), allowed));
  if (document.terrain.kind === 'map') lines.push(words.missing(document.terrain.name));
  if (document.density.kind === 'map') lines.push(words.missingDensity(document.density.name));
  const kind = faults.length > 0 ? 'error' : 'note';
  const title = faults.length > 0 ? words.linkFaults : words.absent(missing.join(', '));
  return { document, notice: lines.length > 0 ? { kind, title, lines } : null };
}

/** The address of a forest as it is seen now. */
export function addressOf(document: ForestDocument, camera: ForestCamera): string {
  return `${location.origin}${location.pathname}${location.search}#${encodeForest({ ...document, camera })}`;
}
