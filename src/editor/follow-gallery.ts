import type { LinkDocument } from '../core/link/link.ts';
import type { Actions } from './actions.ts';
import type { Address } from './address.ts';
import { watch } from './document-store.ts';
import type { Session, SessionStore } from './session.ts';

/** What lies below this entry of the browser's history, as far as the page put it there: addresses, the nearest last. */
interface Below {
  readonly below: readonly string[];
}

const belowOf = (state: unknown): readonly string[] => (state as Partial<Below> | null)?.below ?? [];

/** Where the reader is in the gallery: at a species, among all (''), or not in it. */
const placeOf = ({ dialog, speciesPage }: Session): string | null =>
  dialog === 'gallery' ? (speciesPage ?? '') : null;

const hashOf = (place: string): string => (place === '' ? '#gallery' : `#gallery=${place}`);

/**
 * Gives the gallery and every page in it an address of their own, so that the browser's back and forward buttons turn its pages and links
 * to a species work; meanwhile nothing of the document is written there.
 */
export function followGallery(page: {
  readonly session: SessionStore;
  readonly actions: Pick<Actions, 'openGallery' | 'closeDialog'>;
  readonly address: Address;
  now(): LinkDocument;
  /** The picture can be seen again. */
  uncovered(): void;
}): void {
  const { session, actions, address, now } = page;
  /** What changes now was asked for by the browser's buttons: its address is there already. */
  let asked = false;

  const open = (place: string): void => {
    // An address that says nothing yet is that of the gallery from now on.
    const nothing = address.gallery === null && !address.asks;
    if (!nothing && address.gallery === null) {
      address.write(now());
      address.flush();
    }
    address.hold();
    const below = [...belowOf(history.state), location.href];
    if (nothing) history.replaceState({ below: [] } satisfies Below, '', hashOf(place));
    else history.pushState({ below } satisfies Below, '', hashOf(place));
  };
  const turn = (place: string, from: string): void => {
    const below = belowOf(history.state);
    if (place === '' && below.at(-1)?.endsWith(hashOf(''))) history.back();
    else if (place === '' || from !== '') history.replaceState({ below } satisfies Below, '', hashOf(place));
    else history.pushState({ below: [...below, location.href] } satisfies Below, '', hashOf(place));
  };
  const close = (): void => {
    const below = belowOf(history.state);
    const last = below.findLastIndex((href) => !/#gallery(=|$)/.test(href));
    // Nothing was chosen: back to where one came from. The address is let go when it is there.
    if (last >= 0 && below[last] === address.of(now())) history.go(last - below.length);
    else address.push(now());
  };

  watch(session, placeOf, (place, before) => {
    if (place === null) page.uncovered();
    if (asked) {
      if (place !== null) address.hold();
    } else if (place === null) close();
    else if (before === null) {
      // Opened by its address: that stays.
      if (address.gallery === place) address.hold();
      else open(place);
    } else turn(place, before);
  });
  window.addEventListener('popstate', () => {
    const place = address.gallery;
    asked = true;
    if (place !== null) actions.openGallery(place || null);
    else {
      if (session.getState().dialog === 'gallery') actions.closeDialog();
      address.release();
    }
    asked = false;
  });
}
