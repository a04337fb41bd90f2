import type { Actions } from './actions.ts';
import type { DocumentStore } from './document-store.ts';
import type { Preferences } from './preferences.ts';
import type { SessionStore } from './session.ts';

/** What every part of the interface is given. */
export interface Editor {
  readonly document: DocumentStore;
  readonly session: SessionStore;
  readonly preferences: Preferences;
  readonly actions: Actions;
  /** Calls back with the time in seconds after each frame that was drawn; returns how to stop. */
  readonly onFrame: (listener: (time: number) => void) => () => void;
}
