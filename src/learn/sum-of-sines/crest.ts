import { DEFAULT_WAVE, type Wind } from '../../core/wind/wind.ts';
import { AskedWind, windOf } from './waves.ts';

/** A wave along x, and whether it runs as printed (upwind, erratum E23). */
export const alongX = (wavelength: number, speed: number, paper: boolean): Wind =>
  windOf([{ ...DEFAULT_WAVE, amplitude: 1, wavelength, speed, sharpness: 2 }], { paper });

/** Where within a wavelength of `from` the push along x is greatest, metres; found in the push alone. */
export function crestNear(asked: AskedWind, wavelength: number, from: number, time: number): number {
  const push = (x: number): number => asked.at(x, 0, time)[0];
  const step = wavelength / 64;
  let best = from - wavelength / 2;
  for (let i = 0; i <= 64; i++) {
    const x = from - wavelength / 2 + i * step;
    if (push(x) > push(best)) best = x;
  }
  // Parabolas through three ever closer points: crests are smooth.
  for (const h of [step, step / 16]) {
    const [a, b, c] = [push(best - h), push(best), push(best + h)];
    best += (h * 0.5 * (a - c)) / (a - 2 * b + c);
  }
  return best;
}

/** Speed along x at which a crest is found to travel, m/s. */
export function crestSpeed(wind: Wind, wavelength: number, time: number): number {
  const asked = new AskedWind(wind);
  // So short that the crest that is nearest is the same one.
  const dt = 1 / 64;
  const before = crestNear(asked, wavelength, 0, time);
  return (crestNear(asked, wavelength, before, time + dt) - before) / dt;
}
