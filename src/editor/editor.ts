import { createStore } from 'zustand/vanilla';
import type { LinkDocument } from '../core/link/link.ts';
import type { Actions } from './actions.ts';
import type { Preferences } from './preferences.ts';
import type { SessionStore } from './session.ts';

export type DocumentStore = ReturnType<typeof createDocument>;

/** The one document: what is shown, as the link holds it. */
export const createDocument = (initial: LinkDocument) => createStore<LinkDocument>()(() => initial);

/** What every part of the interface is given. */
export interface Editor {
  readonly document: DocumentStore;
  readonly session: SessionStore;
  readonly preferences: Preferences;
  readonly actions: Actions;
  /** Calls back with the time in seconds after each frame that was drawn; returns how to stop. */
  readonly onFrame: (listener: (time: number) => void) => () => void;
}

/** Calls `listener` whenever what `select` picks changes by identity; returns how to stop. */
export function watch<S, T>(
  store: { getState(): S; subscribe(listener: (state: S) => void): () => void },
  select: (state: S) => T,
  listener: (now: T, before: T) => void,
): () => void {
  let before = select(store.getState());
  return store.subscribe((state) => {
    const now = select(state);
    if (Object.is(now, before)) return;
    const last = before;
    before = now;
    listener(now, last);
  });
}
