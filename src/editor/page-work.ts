import { createStore, del, entries, promisifyRequest } from 'idb-keyval';
import type { Keep } from './autosave.ts';
import { Slots } from './slots.ts';
import { Work } from './work.ts';

/** The reader's work in this browser's IndexedDB. */
export function pageWork(): Work {
  const store = createStore('windgrove', 'work');
  const keep: Keep = {
    entries: () => entries<string, unknown>(store),
    set: (key, value) =>
      store('readwrite', (work) => {
        work.put(value, key);
        // A page that is leaving does not hear the answer, and a transaction that nobody ends is undone.
        work.transaction.commit?.();
        return promisifyRequest(work.transaction);
      }),
    del: (key) => del(key, store),
  };
  const newSlot = (): string =>
    [...crypto.getRandomValues(new Uint8Array(8))].map((byte) => byte.toString(16).padStart(2, '0')).join('');
  return new Work(keep, new Slots(), newSlot);
}
