import { ORIGIN, type Placement } from './place.ts';
import { type Gust, gustRepeat } from './wind.ts';

export { gustRepeat } from './wind.ts';

/** Most gusts that the force sums at one time. */
export const MAX_GUSTS = 8;

/** Metres around a tree's place within which its gusts are all there; what is farther away may be left out. */
export const GUST_REACH = 200;

/** The gusts that can be felt around a tree at one time. Twin: the uniforms of shaders/wind/gust.glsl. */
export interface GustUniforms {
  /** Gusts in use, 0..8. */
  gustCount: number;
  /**
   * 12 a gust: direction x, direction y (unit, tree axes), peak in metres, 1/width (0: without end) | 1/speed in seconds a metre, seconds
   * since the front passed the tree's place, rise, fall in seconds | how far left of the gust's axis the tree stands in metres, seconds
   * after which it comes again (0: never), how often it came before this time, 0.
   */
  gusts: Float32Array;
}

export const createGustUniforms = (): GustUniforms => ({ gustCount: 0, gusts: new Float32Array(12 * MAX_GUSTS) });

/** A gust that blows, and its peak in metres: its amplitude by all factors on it. */
export interface BlowingGust {
  gust: Gust;
  peak: number;
}

/** So many half widths from the axis nothing is felt: 2^-25 of the peak. */
const HALF_WIDTHS = 5;

/** Seconds; a rise or fall shorter than this would be a jump. */
const SHORTEST = 1e-3;

/** 0..1 of the peak, `s` seconds after the front: up within `rise`, down within `fall`, both without a corner. Twin: shaders/wind/gust.glsl. */
export function gustEnvelope(s: number, rise: number, fall: number): number {
  const x = Math.min(Math.max(Math.min(s / rise, 1 + (rise - s) / fall), 0), 1);
  return x * x * (3 - 2 * x);
}

/** 0..1 of the peak, `d` metres off the axis of a front of `1/perWidth` metres: a half at half the width. Twin: shaders/wind/gust.glsl. */
export function gustWidth(d: number, perWidth: number): number {
  const x = 2 * d * perWidth;
  return 2 ** -(x * x);
}

/**
 * Seconds since the last front of a train of them, by those since one of which `before` came before it, every `repeat` seconds; before the
 * first of them less than 0. Twin: shaders/wind/gust.glsl.
 */
export const sinceFront = (s: number, repeat: number, before: number): number =>
  s - repeat * Math.max(Math.floor(s / Math.max(repeat, SHORTEST)), -before);

/** How hard gust i pushes at (x, y) along its direction, in metres. Twin: shaders/wind/gust.glsl. */
export function gustPush({ gusts }: GustUniforms, i: number, x: number, y: number): number {
  const at = 12 * i;
  const dx = gusts[at];
  const dy = gusts[at + 1];
  const s = sinceFront(gusts[at + 5] - (dx * x + dy * y) * gusts[at + 4], gusts[at + 9], gusts[at + 10]);
  const d = gusts[at + 8] + dx * y - dy * x;
  return gusts[at + 2] * gustEnvelope(s, gusts[at + 6], gusts[at + 7]) * gustWidth(d, gusts[at + 3]);
}

/** Force of all gusts at (x, y) in tree axes: metres, horizontal. Twin: shaders/wind/gust.glsl. */
export function gustsForce(w: GustUniforms, x: number, y: number): [x: number, y: number] {
  let fx = 0;
  let fy = 0;
  for (let i = 0; i < w.gustCount; i++) {
    const push = gustPush(w, i, x, y);
    fx += w.gusts[12 * i] * push;
    fy += w.gusts[12 * i + 1] * push;
  }
  return [fx, fy];
}

/** When the front of a gust passes the world point (x, y) for the first time, seconds. */
export const gustArrival = (gust: Gust, x: number, y: number): number =>
  gust.start + (Math.cos(gust.direction) * (x - gust.x) + Math.sin(gust.direction) * (y - gust.y)) / gust.speed;

/** How far left of the axis of a gust the world point (x, y) lies, metres. */
const gustOffset = (gust: Gust, x: number, y: number): number =>
  Math.cos(gust.direction) * (y - gust.y) - Math.sin(gust.direction) * (x - gust.x);

/** The most that a gust pushes within `GUST_REACH` of the world point (x, y) at `time`, metres: continuous in time. */
function gustLoudness({ gust, peak }: BlowingGust, time: number, x: number, y: number): number {
  const s = time - gustArrival(gust, x, y);
  const reach = GUST_REACH / gust.speed;
  const [from, to] = [Math.max(s - reach, 0), s + reach];
  if (!(peak > 0) || to <= 0) return 0;
  const nearest = Math.max(0, Math.abs(gustOffset(gust, x, y)) - GUST_REACH);
  if (gust.width > 0 && 2 * nearest > HALF_WIDTHS * gust.width) return 0;
  return peak * loudest(gust, from, to) * gustWidth(nearest, gust.width > 0 ? 1 / gust.width : 0);
}

/** The most that the envelope of a gust is from `from` to `to` seconds after its first front, 0 <= from <= to. */
function loudest(gust: Gust, from: number, to: number): number {
  const repeat = gustRepeat(gust);
  const [rise, fall] = [Math.max(gust.rise, SHORTEST), Math.max(gust.fall, SHORTEST)];
  const within = (a: number, b: number): number => gustEnvelope(Math.min(Math.max(rise, a), b), rise, fall);
  if (repeat === 0) return within(from, to);
  const first = Math.floor(from / repeat) * repeat;
  const last = Math.floor(to / repeat) * repeat;
  if (last - first > 1.5 * repeat) return 1;
  return Math.max(within(from - first, to - first), within(Math.max(from - last, 0), to - last));
}

/**
 * How a gust ranks among others as loud, 0.6..1, for its whole life: without it nine alike, as from a key that is pressed nine times,
 * would all be weakened to nothing.
 */
const standing = ({ start }: Gust): number => 1 - 0.4 * (start * GOLDEN - Math.floor(start * GOLDEN));

/** Multiples of it, less their whole part, lie evenly apart. */
const GOLDEN = 0.6180339887498949;

/**
 * Writes the gusts that can be felt at `time` seconds within 200 m of a tree at `place` to `out`. Of more than eight the loudest
 * stay, each weakened towards the loudness of the ninth, so that none comes or goes with a jump.
 */
export function fillGusts(out: GustUniforms, blowing: readonly BlowingGust[], time: number, place = ORIGIN): void {
  out.gustCount = 0;
  const felt: (BlowingGust & { loudness: number })[] = [];
  for (const { gust, peak } of blowing) {
    const loudness = gustLoudness({ gust, peak }, time, place.x, place.y) * standing(gust);
    if (loudness > 0) felt.push({ gust, peak, loudness });
  }
  let ninth = 0;
  if (felt.length > MAX_GUSTS) {
    felt.sort((a, b) => b.loudness - a.loudness);
    ninth = felt[MAX_GUSTS].loudness;
    felt.length = MAX_GUSTS;
  }
  for (const { gust, peak, loudness } of felt) {
    writeGust(out, gust, peak * Math.min(1, 4 * (1 - ninth / loudness)), time, place);
  }
  // The shader sums every slot: those not in use push nothing, and divide by no 0.
  out.gusts.fill(0, 12 * out.gustCount);
  for (let i = out.gustCount; i < MAX_GUSTS; i++) out.gusts[12 * i + 6] = out.gusts[12 * i + 7] = 1;
}

function writeGust(out: GustUniforms, gust: Gust, peak: number, time: number, place: Placement): void {
  const at = 12 * out.gustCount++;
  const { gusts } = out;
  const angle = gust.direction - place.yaw;
  gusts[at] = Math.cos(angle);
  gusts[at + 1] = Math.sin(angle);
  gusts[at + 2] = peak;
  gusts[at + 3] = gust.width > 0 ? 1 / gust.width : 0;
  gusts[at + 4] = 1 / gust.speed;
  // Of a train of fronts the one that is nearest to the tree: single precision knows its time for months.
  const repeat = gustRepeat(gust);
  const since = time - gustArrival(gust, place.x, place.y);
  const before = repeat > 0 ? Math.max(0, Math.round((since - (gust.rise + gust.fall) / 2) / repeat)) : 0;
  gusts[at + 5] = since - before * repeat;
  gusts[at + 6] = Math.max(gust.rise, SHORTEST);
  gusts[at + 7] = Math.max(gust.fall, SHORTEST);
  gusts[at + 8] = gustOffset(gust, place.x, place.y);
  gusts[at + 9] = repeat;
  gusts[at + 10] = before;
  gusts[at + 11] = 0;
}
