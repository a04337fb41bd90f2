import type { SpeciesEdits } from '../species/edits.ts';
import type { Season } from '../species/season.ts';
import type { Wind } from '../wind/wind.ts';

/** How the tree is drawn. */
export const VIEW_MODES = ['shaded', 'wireframe', 'control', 'levels'] as const;
export type ViewMode = (typeof VIEW_MODES)[number];

/** The colours of the page: those of the reader's system, or one of the two. */
export const THEMES = ['auto', 'light', 'dark'] as const;
export type Theme = (typeof THEMES)[number];

/** How two winds are shown: one picture with a line between them, or two side by side. */
export const LAYOUTS = ['split', 'side'] as const;
export type Layout = (typeof LAYOUTS)[number];

/** Where the tree stands, and in what light: `meadow` has a morning in the light theme and a dusk in the dark one. */
export const STAGES = ['meadow', 'park', 'golden', 'studio'] as const;
export type StageId = (typeof STAGES)[number];

/** Steps of the clock a second; the time of a document is a whole number of them. */
export const STEPS_PER_SECOND = 60;

/** `levelsShown` that leaves no level out. */
export const ALL_LEVELS = 9;

/** `preset` of a wind that began as none that ships: the link holds its name, too. */
export const OWN_WIND = 'own';

/** Where the camera stands, seen from what it looks at; y-up, as the picture is. */
export interface CameraPose {
  /** Degrees about the vertical, 0..360; 0 looks from +z. */
  readonly azimuth: number;
  /** Degrees above the horizon, -90..90. */
  readonly elevation: number;
  /** Metres to the target, > 0. */
  readonly distance: number;
  /** Metres. */
  readonly target: readonly [number, number, number];
}

/** A second wind on the same tree, clock and camera. */
export interface Comparison {
  readonly wind: Wind;
  /** As `LinkDocument.preset`. */
  readonly preset: string;
  readonly layout: Layout;
  /** Where the line of `split` stands, 0..1 of the width. */
  readonly at: number;
}

/** What is drawn over the picture. */
export interface OverlayChoice {
  /** Arrows of the force over the ground. */
  readonly arrows: boolean;
  /** Fronts of gusts on the ground. */
  readonly fronts: boolean;
  /** The handle that turns the wind. */
  readonly handle: boolean;
}

export const OVERLAYS: Readonly<OverlayChoice> = { arrows: false, fronts: true, handle: true };

/** All that a link holds: the same document gives the same picture in the same window. */
export interface LinkDocument {
  /** Id of a species that ships, the one that is shown where `ownSpecies` is null. */
  readonly species: string;
  /** The text of a species file of the reader's own, or null. */
  readonly ownSpecies: string | null;
  /** What the reader changed of that species. */
  readonly edits: SpeciesEdits;
  /** What the reader calls the edited tree; null: as its species. One line, 1 to 80 characters, no space at its ends. */
  readonly treeName: string | null;
  /** Unsigned 32-bit integer. */
  readonly seed: number;
  /** Seconds, a whole number of steps of the clock, >= 0. */
  readonly time: number;
  readonly paused: boolean;
  /** How fast time runs, 0.1..2. */
  readonly rate: number;
  /** null: the whole tree in the window. */
  readonly camera: CameraPose | null;
  /** Levels below this one are drawn, 1..ALL_LEVELS. */
  readonly levelsShown: number;
  readonly showLeaves: boolean;
  readonly view: ViewMode;
  readonly theme: Theme;
  readonly season: Season;
  readonly stage: StageId;
  /** Hour of the day by the sun, 0..24; null: the stage's own. */
  readonly hour: number | null;
  readonly overlays: OverlayChoice;
  /** Piece that the probe sticks to, or null. */
  readonly probe: number | null;
  /** false: no wind, whatever `wind` says. */
  readonly blowing: boolean;
  /** Id of the wind that ships and that `wind` began as, or `OWN_WIND`. */
  readonly preset: string;
  readonly wind: Wind;
  /** What stands beside `wind`, or null. */
  readonly compare: Comparison | null;
}
