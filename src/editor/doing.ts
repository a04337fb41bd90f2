import type { LinkDocument } from '../core/link/link.ts';
import type { DocumentStore } from './document-store.ts';
import type { Preferences } from './preferences.ts';
import type { Notice, SessionStore } from './session.ts';

/** What the actions need of the clock. */
export interface Time {
  readonly time: number;
  play(): void;
  pause(): void;
  step(steps: number): void;
  seek(seconds: number): void;
  rate: number;
}

/** What needs the rest of the page. */
export interface Services {
  /** Copies the link of the document. */
  share(): Promise<void>;
  cancelGrowing(): void;
  /** Puts text into the clipboard; rejects where the browser does not let it. */
  copy(text: string): Promise<void>;
  /** Gives the reader a file. */
  save(name: string, text: string): void;
}

/** What all groups of actions work with. */
export interface Doing {
  readonly document: DocumentStore;
  readonly session: SessionStore;
  readonly preferences: Preferences;
  readonly clock: Time;
  readonly services: Services;
  set(change: Partial<LinkDocument>): void;
  /** Spoken by screen readers. */
  say(spoken: string): void;
  notify(kind: Notice['kind'], title: string, lines?: readonly string[]): void;
}
