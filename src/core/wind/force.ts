import { power, sinTurns } from '../math/trig.ts';
import { createGustUniforms, type GustUniforms, gustsForce } from './gust.ts';
import { ORIGIN, type Placement } from './place.ts';
import { createProfileUniforms, type ProfileUniforms, profileFactor } from './profile.ts';
import { createRecordUniforms, type RecordUniforms, recordForce } from './record-state.ts';
import { blowingWaves, type Wave, type Wind } from './wind.ts';

export type { Placement } from './place.ts';

/** Most waves that the force sums: a wind of eight, and eight more while it fades into another. */
export const MAX_WAVES = 16;

/** Waves at one time, seen from one tree; in double for exact work. Twin: the uniforms of shaders/wind/force.glsl. */
export interface Waves<Numbers extends Float32Array | Float64Array> {
  /** Waves in use, 0..16. */
  count: number;
  /** 4 a wave: direction x, direction y (unit, tree axes), peak in metres, sharpness k. */
  waves: Numbers;
  /**
   * 4 a wave: turns a metre (1/wavelength) | phase in turns: the sine's argument is x * (direction . position) - y | the mean that is taken
   * off the push of peak 1, 0 unless the wind is to have none | 0.
   */
  phases: Numbers;
}

/** What the waves of the force shader take. */
export type WaveUniforms = Waves<Float32Array>;

type AnyWaves = Waves<Float32Array | Float64Array>;

/** All that the force is made of. */
export interface ForceUniforms extends AnyWaves, GustUniforms, ProfileUniforms, RecordUniforms {}

const createWaveUniforms = (): WaveUniforms => ({
  count: 0,
  waves: new Float32Array(4 * MAX_WAVES),
  phases: new Float32Array(4 * MAX_WAVES),
});

export const createForceUniforms = (): ForceUniforms & WaveUniforms => ({
  ...createWaveUniforms(),
  ...createGustUniforms(),
  ...createProfileUniforms(),
  ...createRecordUniforms(),
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
 * Appends one wave at `time` seconds to `out`, as a tree at `place` feels it: its place and yaw are folded into direction and phase.
 * `peak` is its amplitude by all factors on it, `mean` how much of its mean push is taken off (0..1), `paper` its direction of travel.
 * A wave without force takes no slot; beyond sixteen it is dropped.
 */
export function appendWave(
  out: AnyWaves,
  wave: Wave,
  peak: number,
  mean: number,
  paper: boolean,
  time: number,
  place: Readonly<Placement> = ORIGIN,
): void {
  if (!(peak > 0) || out.count === MAX_WAVES) return;
  const cos = Math.cos(place.yaw);
  const sin = Math.sin(place.yaw);
  const dx = Math.cos(wave.direction);
  const dy = Math.sin(wave.direction);
  const at = 4 * out.count++;
  out.waves[at] = dx * cos + dy * sin;
  out.waves[at + 1] = dy * cos - dx * sin;
  out.waves[at + 2] = peak;
  out.waves[at + 3] = wave.sharpness;
  out.phases[at] = 1 / wave.wavelength;
  out.phases[at + 1] = wrapTurns(phaseAt(wave, time, paper) - (dx * place.x + dy * place.y) / wave.wavelength);
  out.phases[at + 2] = mean > 0 ? mean * meanPush(wave.sharpness) : 0;
  out.phases[at + 3] = 0;
}

/** Appends the waves of a wind that blow at `time` seconds, weighted by `weight`, to `out`, as a tree at `place` feels them. */
export function appendWaves<Out extends AnyWaves>(
  out: Out,
  wind: Wind,
  time: number,
  weight: number,
  place: Readonly<Placement> = ORIGIN,
): Out {
  const mean = wind.zeroMean ? 1 : 0;
  for (const wave of blowingWaves(wind)) {
    appendWave(out, wave, wave.amplitude * wind.strength * weight, mean, wind.paper, time, place);
  }
  return out;
}

/**
 * How hard wave i pushes at (x, y) along its direction, in metres: A (((1 + sin)/2)^k - mean). Source: Skjermo 2007, equation 14 (errata
 * E23 to E27). Twin: shaders/wind/force.glsl.
 */
export function wavePush({ waves, phases }: AnyWaves, i: number, x: number, y: number): number {
  const s = sinTurns(phases[4 * i] * (waves[4 * i] * x + waves[4 * i + 1] * y) - phases[4 * i + 1]);
  return waves[4 * i + 2] * (power(0.5 + 0.5 * s, waves[4 * i + 3]) - phases[4 * i + 2]);
}

/**
 * Force of the waves alone at (x, y) in tree axes: metres of displacement, horizontal. Each pushes along its direction, and never against
 * it unless its mean is taken off. Twin: shaders/wind/force.glsl.
 */
export function wavesForce(w: AnyWaves, x: number, y: number): [x: number, y: number] {
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
 * Force of the wind at (x, y, z) in tree space: metres of displacement, horizontal: waves, gusts and record, all by the factor of the height
 * z above the ground. Twin: shaders/wind/force.glsl.
 */
export function windForce(w: ForceUniforms, x: number, y: number, z: number): [x: number, y: number] {
  const force = wavesForce(w, x, y);
  if (w.gustCount > 0) {
    const gusts = gustsForce(w, x, y);
    force[0] += gusts[0];
    force[1] += gusts[1];
  }
  if (w.record !== null) {
    const record = recordForce(w, x, y);
    force[0] += record[0];
    force[1] += record[1];
  }
  if (w.profiled === 1) {
    const factor = profileFactor(w, z);
    force[0] *= factor;
    force[1] *= factor;
  }
  return force;
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
    const f = w.waves[4 * i + 2] * sinTurns(w.phases[4 * i] * (dx * x + dy * y) - w.phases[4 * i + 1]);
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
