import { createStore } from 'zustand/vanilla';
import type { Species } from '../core/species/species.ts';
import type { FrameFigures } from '../view/picture/picture.ts';

/** A species of `species/index.json`. */
export interface SpeciesEntry {
  readonly id: string;
  readonly name: string;
  readonly latin: string;
  readonly file: string;
}

/** Something to tell the reader; its words are text, never markup. */
export interface Notice {
  readonly id: number;
  /** Errors and warnings stay until they are closed. */
  readonly kind: 'error' | 'warning' | 'note';
  readonly title: string;
  readonly lines: readonly string[];
}

/** What a tree counts, for the statistics. */
export interface TreeFigures {
  /** Levels of stems that there are. */
  readonly levels: number;
  /** Clones among them. */
  readonly stems: number;
  readonly pieces: number;
  readonly leaves: number;
  /** Metres. */
  readonly height: number;
  /** Milliseconds that growing, fitting and packing took. */
  readonly grow: number;
}

/** What the last frames took. */
export interface Frames extends FrameFigures {
  /** Milliseconds from frame to frame while playing; 0 where time stands. */
  readonly interval: number;
}

/** The tree on the screen. */
export interface ShownTree {
  readonly species: Species;
  readonly seed: number;
  readonly figures: TreeFigures;
}

/** Where the sheet of a narrow window stands. */
export const DETENTS = ['bar', 'third', 'two-thirds', 'all'] as const;
export type Detent = (typeof DETENTS)[number];

/** Panels of the editor; on a narrow window the tabs of the sheet. */
export const PANELS = ['grow', 'wind', 'time', 'view'] as const;
export type Panel = (typeof PANELS)[number];

/** What the editor knows beside the document: nothing of it is in the link. */
export interface Session {
  readonly species: readonly SpeciesEntry[];
  readonly tree: ShownTree | null;
  /** What is growing, and how far it is (0..1); null while nothing grows. */
  readonly growing: { readonly name: string; readonly progress: number } | null;
  readonly notices: readonly Notice[];
  readonly frames: Frames | null;
  /** Spoken by screen readers. */
  readonly spoken: string;
  /** One line for a first visit, empty afterwards. */
  readonly hint: string;
  readonly help: boolean;
  /** The window is too narrow for panels at its sides. */
  readonly narrow: boolean;
  readonly detent: Detent;
  readonly tab: Panel;
}

export type SessionStore = ReturnType<typeof createSession>;

export const createSession = (initial: Partial<Session> = {}) =>
  createStore<Session>()(() => ({
    species: [],
    tree: null,
    growing: null,
    notices: [],
    frames: null,
    spoken: '',
    hint: '',
    help: false,
    narrow: false,
    detent: 'third',
    tab: 'grow',
    ...initial,
  }));
