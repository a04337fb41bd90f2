import type { Wind } from '../wind/wind.ts';

/** How the tree is drawn. */
export const VIEW_MODES = ['shaded', 'wireframe', 'control', 'levels'] as const;
export type ViewMode = (typeof VIEW_MODES)[number];

/** The colours of the page: those of the reader's system, or one of the two. */
export const THEMES = ['auto', 'light', 'dark'] as const;
export type Theme = (typeof THEMES)[number];

/** Steps of the clock a second; the time of a document is a whole number of them. */
export const STEPS_PER_SECOND = 60;

/** `levelsShown` that leaves no level out. */
export const ALL_LEVELS = 9;

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

/** All that a link holds: the same document gives the same picture in the same window. */
export interface LinkDocument {
  /** Id of a species that ships, the one that is shown where `ownSpecies` is null. */
  readonly species: string;
  /** The text of a species file of the reader's own, or null. */
  readonly ownSpecies: string | null;
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
  /** false: no wind, whatever `wind` says. */
  readonly blowing: boolean;
  /** Id of the preset that `wind` began as. */
  readonly preset: string;
  readonly wind: Wind;
}
