import type { Picture } from '../view/picture/picture.ts';
import type { Actions } from './actions.ts';
import type { DocumentStore } from './document-store.ts';
import type { Preferences } from './preferences.ts';
import type { SessionStore } from './session.ts';
import type { Studio } from './studio/studio.ts';

/** What every part of the interface is given. */
export interface Editor {
  readonly document: DocumentStore;
  readonly session: SessionStore;
  readonly preferences: Preferences;
  readonly actions: Actions;
  readonly picture: Picture;
  /** What measures the wind and the answer of a branch. */
  readonly studio: Studio;
  /** Calls back with the time in seconds after each frame that was drawn; returns how to stop. */
  readonly onFrame: (listener: (time: number) => void) => () => void;
}
