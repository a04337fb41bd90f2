import type { LinkDocument, LinkFault } from '../core/link/link.ts';
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

/** A file on the reader's disk; `handle` where the browser can write it again in place. */
export interface DiskFile {
  readonly name: string;
  readonly handle: FileSystemFileHandle | null;
}

/** What needs the rest of the page. */
export interface Services {
  /** The document at this moment: while time runs, the clock knows it. */
  now(): LinkDocument;
  /** The document of a first visit. */
  first(): LinkDocument;
  /** The whole address that shows a document. */
  addressOf(document: LinkDocument): string;
  /** What a link cannot hold of a document, a sentence each. */
  notInLink(document: LinkDocument): string[];
  /** Reads a link as the address has it. */
  read(link: string): { readonly document: LinkDocument; readonly faults: readonly LinkFault[] };
  /** Shows a document whole, its time and camera too, as one step. */
  show(document: LinkDocument): void;
  /** Milliseconds since 1970. */
  when(): number;
  /** A small picture of what is shown as a data: address; null: there is none. */
  thumbnail(): Promise<string | null>;
  /**
   * Writes a file: in place where there is a handle, else where the reader says or among the downloads. null: called off.
   * Rejects where it could not be written.
   */
  write(file: DiskFile, text: string): Promise<DiskFile | null>;
  /** Lets the reader choose a file; null: none. */
  pick(): Promise<{ readonly file: File; readonly handle: FileSystemFileHandle | null } | null>;
  /** Copies the link of the document. */
  share(): Promise<void>;
  cancelGrowing(): void;
  /** Puts text into the clipboard; rejects where the browser does not let it. */
  copy(text: string): Promise<void>;
  /** Gives the reader a file: JSON where it is text. */
  save(name: string, content: string | Blob): void;
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
  notify(kind: Notice['kind'], title: string, lines?: readonly string[], offer?: Notice['offer']): void;
}
