import { type WindState, windStateAt } from '../../../src/core/wind/fade.ts';
import { forceOfSpeed } from '../../../src/core/wind/speed.ts';
import { DEFAULT_WAVE, STILL, type Wave, type Wind } from '../../../src/core/wind/wind.ts';

const wave = (
  amplitude: number,
  degrees: number,
  wavelength: number,
  speed: number,
  sharpness: number,
  phase: number,
): Wave => ({
  ...DEFAULT_WAVE,
  amplitude,
  direction: (degrees * Math.PI) / 180,
  wavelength,
  speed,
  sharpness,
  phase,
});

/** A strong wind of four waves from about one side. */
export const GALE: Wind = {
  ...STILL,
  name: 'Gale',
  waves: [
    wave(0.22, 15, 60, 14.5, 2, 0),
    wave(0.1, -16, 26, 12, 1.8, 0.37),
    wave(0.055, 34, 13, 9.4, 1.6, 0.71),
    wave(0.035, -42, 8, 10.3, 1.5, 0.18),
  ],
};

/** The upper end of Beaufort 11: gusts whose peaks together reach 32.6 m/s, as a force. */
export const BEAUFORT_11 = forceOfSpeed(32.6);

const PEAKS = GALE.waves.reduce((sum, { amplitude }) => sum + amplitude, 0);

/** The gale with peaks that reach a force, in metres. */
export const galeOf = (force: number, change: Partial<Wind> = {}): Wind => ({
  ...GALE,
  strength: 1,
  waves: GALE.waves.map((each) => ({ ...each, amplitude: (each.amplitude * force) / PEAKS })),
  ...change,
});

/** A wind that blows everywhere alike and always: metres of force, degrees. */
export const steady = (force: number, degrees = 0, change: Partial<Wind> = {}): Wind => ({
  ...STILL,
  waves: [wave(force, degrees, 1e9, 0, 1, -0.25)],
  ...change,
});

export const stateOf = (wind: Wind, time: number, change: Partial<WindState> = {}): WindState => ({
  ...windStateAt(wind, time),
  ...change,
});
