import { ALL_LEVELS, type LinkDocument, OVERLAYS, roundDocument, type Theme } from '../core/link/link.ts';
import type { Wind } from '../core/wind/wind.ts';

/** Id of the wind that a first visit feels. */
export const FIRST_WIND = 'breeze';

/** What a first visit sees: the aspen in a breeze, moving unless the reader's system asks for less motion. */
export const firstDocument = (theme: Theme, paused: boolean, breeze: Wind): LinkDocument =>
  roundDocument({
    species: 'quaking-aspen',
    ownSpecies: null,
    edits: {},
    treeName: null,
    seed: 1,
    time: 0,
    paused,
    rate: 1,
    camera: null,
    levelsShown: ALL_LEVELS,
    showLeaves: true,
    view: 'shaded',
    theme,
    season: 'summer',
    stage: 'meadow',
    hour: null,
    overlays: { ...OVERLAYS },
    probe: null,
    blowing: true,
    preset: FIRST_WIND,
    wind: breeze,
    compare: null,
  });
