import { encodeLink, type LinkDocument } from '../core/link/link.ts';
import type { Workspace } from './workspace.ts';

/** Work that was found in the browser, and the slot that it was kept in. */
export interface Found {
  readonly slot: string;
  readonly workspace: Workspace;
}

/** What a page begins with. */
export type Start =
  /** What the address says, or a first visit; `before` is kept as a snapshot: nothing is lost. */
  | { readonly kind: 'fresh'; readonly before: Found | null }
  /** Work that was kept; `told`: the reader did not ask for it, so a message says what came back. */
  | { readonly kind: 'restored'; readonly found: Found; readonly told: boolean }
  /** Work of this tab, and what the address says as one more step. */
  | { readonly kind: 'continued'; readonly found: Found };

/** The link of what was made: the same for documents that differ in what is only looked at, or in what no link holds. */
const madeLink = (document: LinkDocument): string =>
  encodeLink({ ...document, time: 0, paused: false, rate: 1, camera: null, theme: 'auto' });

/** Steps that can be made before the address has followed. */
const UNWRITTEN = 5;

/** Where a tab was a moment before it was loaded again: its address may still say that. */
const lately = ({ workspace: { past, future } }: Found, link: LinkDocument): LinkDocument[] =>
  [...past.slice(-UNWRITTEN), ...future.slice(-UNWRITTEN)].map((made) => ({ ...link, ...made }));

/** Whether there is anything that opening the address again would not bring back. */
const isWork = ({ past, future, snapshots, file }: Workspace): boolean =>
  past.length > 0 || future.length > 0 || snapshots.length > 0 || file !== null;

/**
 * Decides what a page begins with.
 *
 * `link` is what the address asks for, null where it asks for nothing; `own` what this tab kept; `others` what tabs kept that live no
 * more, the latest first.
 */
export function chooseStart(link: LinkDocument | null, own: Found | null, others: readonly Found[]): Start {
  if (link === null) {
    const found = own ?? others[0];
    return found ? { kind: 'restored', found, told: true } : { kind: 'fresh', before: null };
  }
  const wanted = madeLink(link);
  const same = [own, ...others].find((found) => found && madeLink(found.workspace.document) === wanted);
  if (same) return { kind: 'restored', found: same, told: false };
  if (own && lately(own, link).some((state) => madeLink(state) === wanted))
    return { kind: 'restored', found: own, told: false };
  if (own) return { kind: 'continued', found: own };
  return { kind: 'fresh', before: others.find(({ workspace }) => isWork(workspace)) ?? null };
}
