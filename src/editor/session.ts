import { createStore } from 'zustand/vanilla';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import type { WizardChoice } from '../core/wind/wizard.ts';
import type { FrameFigures, Insets } from '../view/picture/picture.ts';

/** A species of `species/index.json`. */
export interface SpeciesEntry {
  readonly id: string;
  readonly name: string;
  readonly latin: string;
  readonly file: string;
}

/** A wind that ships: an entry of `winds/index.json`, and what its file says. */
export interface ShippedWind {
  readonly id: string;
  readonly name: string;
  readonly description: string;
  /** Address of a small picture. */
  readonly thumbnail: string;
  /** With the digits that a document keeps. */
  readonly wind: Wind;
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
  /** With the edits in it: what was grown. */
  readonly species: Species;
  /** Without them: what a reset goes back to. */
  readonly base: Species;
  readonly seed: number;
  readonly figures: TreeFigures;
}

/** Where the sheet of a narrow window stands. */
export const DETENTS = ['bar', 'third', 'two-thirds', 'all'] as const;
export type Detent = (typeof DETENTS)[number];

/** Panels of the editor; on a narrow window the tabs of the sheet. */
export const PANELS = ['grow', 'wind', 'studio', 'time', 'view'] as const;
export type Panel = (typeof PANELS)[number];

/** Which of the two winds that are compared is edited; A where there is one. */
export type Side = 'A' | 'B';

/** What the editor knows beside the document: nothing of it is in the link. */
export interface Session {
  readonly species: readonly SpeciesEntry[];
  readonly winds: readonly ShippedWind[];
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
  /** The next click on the ground throws a gust. */
  readonly throwing: boolean;
  /** A control of the whole wind's direction or strength has the focus: the handle in the scene shows it. */
  readonly handling: boolean;
  readonly side: Side;
  /** What the wizard was told last. */
  readonly wizard: WizardChoice;
  /** Gust of the edited wind that is chosen on the ruler or in the list. */
  readonly gust: number | null;
  /** Piece that stands out in the picture: pointed at in a plot or a texture. */
  readonly highlight: number | null;
  /** Part (0..1) of the way to the wished time that the tree has been moved; null: it is there. */
  readonly catchingUp: number | null;
  /** What the panels cover of the picture. */
  readonly insets: Insets;
  /** The window is too narrow for panels at its sides. */
  readonly narrow: boolean;
  readonly detent: Detent;
  readonly tab: Panel;
}

export type SessionStore = ReturnType<typeof createSession>;

export const createSession = (initial: Partial<Session> = {}) =>
  createStore<Session>()(() => ({
    species: [],
    winds: [],
    tree: null,
    growing: null,
    notices: [],
    frames: null,
    spoken: '',
    hint: '',
    help: false,
    throwing: false,
    handling: false,
    side: 'A',
    wizard: { beaufort: 4, steadiness: 0.4, turbulence: 0.5, stiffness: 1, direction: Math.PI / 12, seed: 1 },
    gust: null,
    highlight: null,
    catchingUp: null,
    insets: { top: 0, right: 0, bottom: 0, left: 0 },
    narrow: false,
    detent: 'third',
    tab: 'grow',
    ...initial,
  }));
