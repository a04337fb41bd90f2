import { hashPcg, hashUnit } from '../math/hash.ts';
import { sinTurns } from '../math/trig.ts';
import { MECHANICS, MECHANICS_SIZE, SWAY_LAYERS } from '../pack/layout.ts';
import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart, texelArray } from '../pack/texel-array.ts';
import { forceOfSpeed } from './speed.ts';
import type { SwaySettings } from './wind.ts';

/** Frequencies are whole multiples of a hertz over this. */
const PARTS = 4096;
/** Fastest swing, hertz. */
const FASTEST = 4;
const RADIANS = Math.PI / 180;

/**
 * a0, degrees: how far a stem of this length bends at the part z of it in a wind of 50, `radius` being that at z; metres.
 * Source: Weber & Penn 1995, 4.7 (lost in the scan; weber-penn.md 1.2).
 */
export const swayReach = (length: number, radius: number, z: number): number =>
  (4 * length * (1 - z)) / Math.max(radius, 1e-6);

/** a1/a0 and a2/a0: the parts of the two sines. Source: Weber & Penn 1995, 4.7. */
export const swayParts = (speed: number, gust: number): [quick: number, slow: number] => [
  speed / 50,
  gust / 50 + speed / 100,
];

/** b less its offset, radians a second: rate r/L as in the paper, or rate r/L^2 as a cantilever's. */
export const swayRate = ({ reading, rate }: Pick<SwaySettings, 'reading' | 'rate'>, radius: number, length: number) =>
  (rate * radius) / (reading === 'ratio' ? length : length * length);

/** a1 sin b + a2 sin 0.7 b over a0, b in radians. Source: Weber & Penn 1995, 4.7. */
export const swaySine = ([quick, slow]: readonly [number, number], b: number): number =>
  quick * Math.sin(b) + slow * Math.sin(0.7 * b);

/**
 * How every piece of a tree swings: a texel array of SWAY_LAYERS, as wide and high as the pieces; `out` is overwritten where given.
 *
 * A stem is taken for a cone, whose a0 is the same all along it; its bend grows evenly from base to tip, as the paper's does by the
 * same turn a segment. The paper's angles are divided by the stiffness of the level, as every bend is. Source: Weber & Penn 1995, 4.7.
 */
export function swayTexels(
  tree: Pick<PackedTree, 'pieceCount' | 'mechanics'>,
  settings: SwaySettings,
  out: TexelArray = texelArray(tree.pieceCount, Object.keys(SWAY_LAYERS).length),
): TexelArray {
  const { data } = out;
  const { mechanics } = tree;
  const gain = layerStart(out, SWAY_LAYERS.GAIN);
  const offset = layerStart(out, SWAY_LAYERS.OFFSET);
  for (let i = 0; i < tree.pieceCount; i++) {
    const at = MECHANICS_SIZE * i;
    const t = 4 * i;
    const length = mechanics[at + MECHANICS.LENGTH];
    const radius = mechanics[at + MECHANICS.RADIUS];
    const share = mechanics[at + MECHANICS.Z1] - mechanics[at + MECHANICS.Z0];
    const most = swayReach(length, radius, 0) * RADIANS * mechanics[at + MECHANICS.FLEXIBILITY] * share;
    const hertz = Math.min(swayRate(settings, radius, length) / (2 * Math.PI), FASTEST);
    const k = Math.max(1, Math.round(hertz * PARTS));
    const phase = mechanics[at + MECHANICS.PHASE];
    // Of an evenly curved piece the second edge turns half as far as the third.
    data[gain + t] = most / 2;
    data[gain + t + 1] = most;
    data[gain + t + 2] = k;
    data[gain + t + 3] = Math.max(1, Math.round(0.7 * k));
    data[offset + t] = phase;
    data[offset + t + 1] = hashUnit(hashPcg(Math.floor(phase * 16777216)));
  }
  return out;
}

/** windSway of the shader: amplitude of the quick sine, of the slow one, stir at a full swing in metres of force, 0. */
export function swayUniform(
  { speed, gust }: Pick<SwaySettings, 'speed' | 'gust'>,
  loudness: number,
  out: Float32Array | Float64Array = new Float32Array(4),
): Float32Array | Float64Array {
  const [quick, slow] = swayParts(speed, gust);
  out[0] = quick * loudness;
  out[1] = slow * loudness;
  out[2] = forceOfSpeed(speed + gust) * loudness;
  out[3] = 0;
  return out;
}

/** windClock of the shader: whole seconds modulo 4096, and the rest. */
export function swayClock(
  time: number,
  out: Float32Array | Float64Array = new Float32Array(2),
): Float32Array | Float64Array {
  const whole = Math.floor(time);
  out[0] = whole - PARTS * Math.floor(whole / PARTS);
  out[1] = time - whole;
  return out;
}

/**
 * Phase in turns of a swing of k/4096 Hz, k whole: exact for as long as the wind blows, since only whole turns are dropped.
 * Twin: shaders/wind/sway.glsl.
 */
export const swayPhase = (k: number, clock: ArrayLike<number>): number =>
  ((Math.imul(k, clock[0]) & (PARTS - 1)) + k * clock[1]) / PARTS;

/**
 * The swing along T and S: a1 sin b + a2 sin 0.7 b with b = offset + turns. `gain` and `offset` are the texels of SWAY_LAYERS.
 * Source: Weber & Penn 1995, 4.7. Twin: shaders/wind/sway.glsl.
 */
export function swaySwing(
  gain: ArrayLike<number>,
  offset: ArrayLike<number>,
  sway: ArrayLike<number>,
  clock: ArrayLike<number>,
): [number, number] {
  const quick = swayPhase(gain[2], clock);
  const slow = swayPhase(gain[3], clock);
  const along = (turns: number): number => sway[0] * sinTurns(quick + turns) + sway[1] * sinTurns(slow + 0.7 * turns);
  return [along(offset[0]), along(offset[1])];
}

/** How hard the leaves are shaken, metres of force. Twin: shaders/wind/sway.glsl. */
export const swayStir = ([x, y]: readonly [number, number], sway: ArrayLike<number>): number =>
  (sway[2] * Math.sqrt(x * x + y * y)) / Math.max(sway[0] + sway[1], 1e-9);
