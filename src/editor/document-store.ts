import { createStore } from 'zustand/vanilla';
import type { LinkDocument } from '../core/link/link.ts';

/** The one document: what is shown, as the link holds it. */
export const createDocument = (initial: LinkDocument) => createStore<LinkDocument>()(() => initial);

export type DocumentStore = ReturnType<typeof createDocument>;

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
