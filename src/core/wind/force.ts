import { power, sinTurns } from '../math/trig.ts';
import type { Wave, Wind } from './wind.ts';

/** Most waves that the force sums: a wind of four, and four more while it fades into another. */
export const MAX_WAVES = 8;

/** Waves at one time, seen from one tree; in double for exact work. Twin: the uniforms of shaders/wind/force.glsl. */
export interface Waves<Numbers extends Float32Array | Float64Array> {
  /** Waves in use, 0..8. */
  count: number;
  /** 4 a wave: direction x, direction y (unit, tree space), peak in metres, sharpness k. */
  waves: Numbers;
  /** 2 a wave: turns a metre (1/wavelength), and phase in turns: the sine's argument is x * (direction . position) - y. */
  phases: Numbers;
}

/** What the force shader takes. */
export type WaveUniforms = Waves<Float32Array>;

type AnyWaves = Waves<Float32Array | Float64Array>;

/** Where a tree stands in the world and how it is turned: metres, and radians from x to y. */
export interface Placement {
  x: number;
  y: number;
  yaw: number;
}

const ORIGIN: Placement = { x: 0, y: 0, yaw: 0 };

export const createWaveUniforms = (): WaveUniforms => ({
  count: 0,
  waves: new Float32Array(4 * MAX_WAVES),
  phases: new Float32Array(2 * MAX_WAVES),
});

/** x less its whole part: a phase in [0, 1) turns. Done in double, so that a wind may blow for years. */
export const wrapTurns = (x: number): number => x - Math.floor(x);

/**
 * The phase of a wave in turns at `time` seconds and at the origin, in [0, 1). It grows with time, so that the crests travel
 * along the direction; the paper's sign makes them travel against it. Source: Skjermo 2007, equation 11 (erratum E23).
 */
export const phaseAt = (wave: Wave, time: number, paper = false): number =>
  wrapTurns((paper ? -1 : 1) * (wave.phase + (wave.speed / wave.wavelength) * time));

/**
 * Appends the waves of a wind at `time` seconds, weighted by `weight`, to `out`, as a tree at `place` feels them: its place and yaw
 * are folded into direction and phase. Waves that are off or without force take no slot; those beyond eight are dropped.
 */
export function appendWaves<Out extends AnyWaves>(
  out: Out,
  wind: Wind,
  time: number,
  weight: number,
  place = ORIGIN,
): Out {
  const cos = Math.cos(place.yaw);
  const sin = Math.sin(place.yaw);
  for (const wave of wind.waves) {
    const peak = wave.on ? wave.amplitude * wind.strength * weight : 0;
    if (peak <= 0 || out.count === MAX_WAVES) continue;
    const dx = Math.cos(wave.direction);
    const dy = Math.sin(wave.direction);
    const i = out.count++;
    out.waves[4 * i] = dx * cos + dy * sin;
    out.waves[4 * i + 1] = dy * cos - dx * sin;
    out.waves[4 * i + 2] = peak;
    out.waves[4 * i + 3] = wave.sharpness;
    out.phases[2 * i] = 1 / wave.wavelength;
    out.phases[2 * i + 1] = wrapTurns(
      phaseAt(wave, time, wind.paper) - (dx * place.x + dy * place.y) / wave.wavelength,
    );
  }
  return out;
}

/** The waves of a wind at `time` seconds for a tree at `place`; `out` is overwritten where it is given. */
export function wavesAt(wind: Wind, time: number, place = ORIGIN, out = createWaveUniforms()): WaveUniforms {
  out.count = 0;
  return appendWaves(out, wind, time, 1, place);
}

/** How hard wave i pushes at (x, y) along its direction, in metres: A ((1 + sin)/2)^k. Twin: shaders/wind/force.glsl. */
export function wavePush({ waves, phases }: AnyWaves, i: number, x: number, y: number): number {
  const s = sinTurns(phases[2 * i] * (waves[4 * i] * x + waves[4 * i + 1] * y) - phases[2 * i + 1]);
  return waves[4 * i + 2] * power(0.5 + 0.5 * s, waves[4 * i + 3]);
}

/**
 * Force of the wind at (x, y) in tree space: metres of displacement, horizontal. Each wave pushes along its direction, never
 * against it. Source: Skjermo 2007, equation 14 (errata E23 to E27). Twin: shaders/wind/force.glsl.
 */
export function windForce(w: AnyWaves, x: number, y: number): [x: number, y: number] {
  let fx = 0;
  let fy = 0;
  for (let i = 0; i < w.count; i++) {
    const push = wavePush(w, i, x, y);
    fx += w.waves[4 * i] * push;
    fy += w.waves[4 * i + 1] * push;
  }
  return [fx, fy];
}

/**
 * Force without peaks, A sin: the wind pulls as much as it pushes. For teaching. Source: Skjermo 2007, equation 13.
 * Twin: shaders/wind/force.glsl.
 */
export function linearWindForce(w: AnyWaves, x: number, y: number): [x: number, y: number] {
  let fx = 0;
  let fy = 0;
  for (let i = 0; i < w.count; i++) {
    const dx = w.waves[4 * i];
    const dy = w.waves[4 * i + 1];
    const f = w.waves[4 * i + 2] * sinTurns(w.phases[2 * i] * (dx * x + dy * y) - w.phases[2 * i + 1]);
    fx += dx * f;
    fy += dy * f;
  }
  return [fx, fy];
}

/** Natural logarithm of the gamma function for x > 0 (Lanczos, g = 7, nine terms; 1e-14). */
function logGamma(x: number): number {
  const c = [
    676.5203681218851, -1259.1392167224028, 771.32342877765313, -176.61502916214059, 12.507343278686905,
    -0.13857109526572012, 9.9843695780195716e-6, 1.5056327351493116e-7,
  ];
  let sum = 0.99999999999980993;
  for (let i = 0; i < c.length; i++) sum += c[i] / (x + i);
  const t = x + 6.5;
  return 0.5 * Math.log(2 * Math.PI) + (x - 0.5) * Math.log(t) - t + Math.log(sum);
}

/**
 * Mean of ((1 + sin)/2)^k over a period: what a wave of peak 1 and sharpness k leans a tree by. k > -1/2.
 * Source: equations.md 5.2 (erratum E26).
 */
export const meanPush = (k: number): number => Math.exp(logGamma(k + 0.5) - logGamma(k + 1)) / Math.sqrt(Math.PI);
