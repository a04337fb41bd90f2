import { createStore } from 'zustand/vanilla';
import type { IndexEntry } from '../core/file/shipped-index.ts';
import type { LinkDocument } from '../core/link/link.ts';
import type { StemTable } from '../core/pack/stem-table.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import type { WizardChoice } from '../core/wind/wizard.ts';
import type { ChannelView, FrameFigures, Insets } from '../view/picture/picture.ts';
import type { Quality } from '../view/picture/quality.ts';
import type { KeptFile } from './kept-file.ts';

/** A species of `species/index.json`. */
export interface SpeciesEntry extends IndexEntry {
  readonly latin: string;
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
  /** A button that the message has; it goes with it. */
  readonly offer?: { readonly label: string; readonly act: () => void };
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
  /** What the document said of it, where it has not changed since. */
  readonly source?: Pick<LinkDocument, 'species' | 'ownSpecies'>;
  readonly seed: number;
  readonly figures: TreeFigures;
  /** What is known of its stems. */
  readonly stems: StemTable;
  /** Leaves or twigs are left out: grown quickly while a control is dragged. */
  readonly draft?: boolean;
}

/** A state that the reader gave a name. */
export interface Snapshot {
  readonly id: string;
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly when: number;
  /** The document as a link. */
  readonly link: string;
  /** The document itself, with what no link holds (a measured wind of the reader's own); null: the link has it all. */
  readonly document: LinkDocument | null;
  /** A small picture as a data: address, or null. */
  readonly thumbnail: string | null;
}

/** Where the sheet of a narrow window stands. */
export const DETENTS = ['bar', 'third', 'two-thirds', 'all'] as const;
export type Detent = (typeof DETENTS)[number];

/** Panels of the editor; on a narrow window the tabs of the sheet. */
export const PANELS = ['grow', 'wind', 'studio', 'time', 'view'] as const;
export type Panel = (typeof PANELS)[number];

/** What can lie over the page: each is loaded when it is first opened (ui/dialogs.ts). */
export type Dialog = 'gallery' | 'help' | 'palette' | 'history' | 'export' | 'variety' | 'tour';

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
  /** The panels at the sides have been loaded. */
  readonly panels: boolean;
  /** The hint offers the tour: on a first visit alone. */
  readonly offer: boolean;
  /** What lies over the page: one at a time. */
  readonly dialog: Dialog | null;
  /** Id of the species whose page lies open in the gallery; null: all of them. */
  readonly speciesPage: string | null;
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
  /** Stem that is selected in the scene, or null; clones are stems of their own. */
  readonly stem: number | null;
  /** Its path (StemTable.path): by it the selection finds its stem in the next tree. */
  readonly stemPath: number | null;
  /** Stem that the mouse points at, or null. */
  readonly hoveredStem: number | null;
  /** Level of stems that the panel shows, 0..3. */
  readonly level: number;
  /** The pruning envelope stands around the tree. */
  readonly envelopeShown: boolean;
  /** Paths of parameters that keep their values when another species is chosen. */
  readonly locks: ReadonlySet<string>;
  /** The species is shown without the edits, to compare. */
  readonly peek: boolean;
  /** Wind channel of engines that colours the tree, or null. */
  readonly channel: ChannelView | null;
  /** A control of the tree is being dragged: what is shown may be a draft. */
  readonly editing: boolean;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** Named states that can be opened again, the latest first. */
  readonly snapshots: readonly Snapshot[];
  /** Whether what is shown is kept on this machine; `failed`: the browser keeps nothing. */
  readonly saved: 'saved' | 'saving' | 'failed';
  /** The project's file as it was opened or saved last; null: none yet. */
  readonly file: KeptFile | null;
  /** Its name. */
  readonly fileName: string | null;
  /** What is shown differs from that file. */
  readonly changed: boolean;
  /** How finely the picture is to be drawn. */
  readonly quality: Quality;
  /** The interface is gone but for a frame and a shutter. */
  readonly photo: boolean;
  /** The page stands in another page: the tree alone, without panels. */
  readonly embed: boolean;
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
    panels: false,
    offer: false,
    dialog: null,
    speciesPage: null,
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
    stem: null,
    stemPath: null,
    hoveredStem: null,
    level: 1,
    envelopeShown: false,
    locks: new Set<string>(),
    peek: false,
    channel: null,
    editing: false,
    canUndo: false,
    canRedo: false,
    snapshots: [],
    saved: 'saved',
    file: null,
    fileName: null,
    changed: false,
    quality: 'auto',
    photo: false,
    embed: false,
    ...initial,
  }));
