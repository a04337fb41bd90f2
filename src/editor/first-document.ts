import { ALL_LEVELS, type LinkDocument, roundDocument, type Theme } from '../core/link/link.ts';
import { DEFAULT_WIND, presets } from '../core/wind/presets.ts';

/** What a first visit sees: the aspen in a breeze, moving unless the reader's system asks for less motion. */
export const firstDocument = (theme: Theme, paused: boolean): LinkDocument =>
  roundDocument({
    species: 'quaking-aspen',
    ownSpecies: null,
    seed: 1,
    time: 0,
    paused,
    rate: 1,
    camera: null,
    levelsShown: ALL_LEVELS,
    showLeaves: true,
    view: 'shaded',
    theme,
    blowing: true,
    preset: DEFAULT_WIND,
    wind: presets[DEFAULT_WIND]!,
  });
