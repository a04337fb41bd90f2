import { temporal } from 'zundo';
import { createStore } from 'zustand/vanilla';
import type { LinkDocument } from '../core/link/link.ts';
import { History, MOST_STEPS } from './history.ts';
import { type Made, madeOf, sameMade } from './made.ts';

/** The one document: what is shown, as the link holds it; and its history, which every change of it goes into. */
export function createDocument(initial: LinkDocument) {
  const store = createStore<LinkDocument>()(
    temporal<LinkDocument, [], [], Made>(() => initial, {
      partialize: madeOf,
      limit: MOST_STEPS,
      equality: sameMade,
      handleSet: (push) => (past, _replace, now) =>
        // zundo types the state as what `setState` takes; what it hands over is what `partialize` gave.
        history.onChange(past as Made, now, () => push(past)),
    }),
  );
  const { setState } = store;
  let depth = 0;
  /** What listeners change in answer to a change belongs to it: one step, in the right order. */
  const nested = (set: () => void): void => {
    const { pause, resume } = store.temporal.getState();
    if (depth > 0) pause();
    depth++;
    try {
      set();
    } finally {
      depth--;
      if (depth > 0) resume();
    }
  };
  const quietly = (act: () => void): void => {
    const { pause, resume } = store.temporal.getState();
    pause();
    try {
      act();
    } finally {
      resume();
    }
  };
  const history = new History({ getState: store.getState, setState, quietly, temporal: store.temporal });
  return Object.assign(store, {
    history,
    setState: ((...change: Parameters<typeof setState>) => nested(() => setState(...change))) as typeof setState,
  });
}

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
