import { createStore } from 'zustand/vanilla';
import type { PiecePlace } from '../../core/wind/probe-place.ts';

export const STUDIO_TABS = ['plots', 'field', 'textures', 'compare', 'anemometer'] as const;
export type StudioTab = (typeof STUDIO_TABS)[number];

/** Seconds of the past that the plots can show. */
export const SPANS = [10, 30, 60] as const;
export type Span = (typeof SPANS)[number];

/** How far the GPU's own piece is from the one that is plotted. */
export interface Trust {
  /** Metres between the two ends. */
  readonly difference: number;
  /** Seconds: when it was looked at. */
  readonly time: number;
}

/** What the studio knows beside the document. */
export interface StudioState {
  readonly open: boolean;
  readonly tab: StudioTab;
  readonly span: Span;
  /** The plots stand still while time goes on. */
  readonly frozen: boolean;
  /** The time that is pointed at in a plot, seconds; null: none. */
  readonly hover: number | null;
  /** Where the probe sits; null while there is no tree. */
  readonly place: PiecePlace | null;
  /** Natural frequency of the probed branch as the wind's settings make it, hertz. */
  readonly natural: number | null;
  /** Part of the past that has been computed, 0..1; null: all of it. */
  readonly catchingUp: number | null;
  readonly trust: Trust | null;
}

export type StudioStore = ReturnType<typeof createStudioStore>;

export const createStudioStore = (initial: Partial<StudioState> = {}) =>
  createStore<StudioState>()(() => ({
    open: false,
    tab: 'plots',
    span: 30,
    frozen: false,
    hover: null,
    place: null,
    natural: null,
    catchingUp: null,
    trust: null,
    ...initial,
  }));
