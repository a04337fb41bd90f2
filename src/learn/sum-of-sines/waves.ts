import { createWindState, type WindState, windStateAt } from '../../core/wind/fade.ts';
import { windForce } from '../../core/wind/force.ts';
import { DEFAULT_WAVE, STILL, type Wave, type Wind } from '../../core/wind/wind.ts';

/** The four waves of this lesson: a gentle breeze; `turn` is how far each is turned out of the wind for a spread of 1. */
const FOUR = [
  { amplitude: 0.135, wavelength: 34, speed: 4.6, phase: 0, turn: 0 },
  { amplitude: 0.067, wavelength: 15, speed: 4.1, phase: 0.37, turn: -0.43 },
  { amplitude: 0.042, wavelength: 8.5, speed: 3.7, phase: 0.71, turn: 0.41 },
  { amplitude: 0.029, wavelength: 6, speed: 4.3, phase: 0.18, turn: -0.86 },
] as const;

/** A wind that is asked at once, of these waves alone. */
export const windOf = (waves: readonly Wave[], changes: Partial<Wind> = {}): Wind => ({
  ...STILL,
  name: 'Of a lesson',
  model: 'direct',
  ...changes,
  waves: [...waves],
});

/** The first `count` of the four, of one sharpness; heading and spread in radians. */
export const someWaves = (count: number, sharpness: number, heading: number, spread: number): Wave[] =>
  FOUR.slice(0, count).map(({ turn, ...wave }) => ({
    ...DEFAULT_WAVE,
    ...wave,
    sharpness,
    direction: heading + turn * spread,
  }));

/** A wind at any time, asked at many places: one state, filled anew where the time changes. */
export class AskedWind {
  readonly wind: Wind;
  readonly #state: WindState = createWindState();
  #time = Number.NaN;

  constructor(wind: Wind) {
    this.wind = wind;
  }

  /** Force at (x, y) on the ground: metres. */
  at(x: number, y: number, time: number): [x: number, y: number] {
    if (time !== this.#time) windStateAt(this.wind, time, undefined, this.#state);
    this.#time = time;
    return windForce(this.#state, x, y, 0);
  }
}
