import { GUST_REACH, gustArrival, gustRepeat } from './gust.ts';
import { ORIGIN, type Placement } from './place.ts';
import { rebaseWave } from './rebase.ts';
import { recordSeconds } from './record-state.ts';
import { blowingWaves, type Gust, MOST_GUSTS, type Wave, type Wind } from './wind.ts';

/** Seconds after which every swing of the model `sway` begins again: their frequencies are whole multiples of a hertz over this. */
export const SWAY_SECONDS = 4096;

/** Metres around a tree's place that its loop is made for. */
const TREE_REACH = 40;

const blows = (wind: Wind, wave: Wave): boolean => wave.amplitude > 0 && wind.strength > 0;
const moves = (wind: Wind, wave: Wave): boolean => blows(wind, wave) && wave.speed > 0;
const plays = ({ record, strength }: Wind): boolean => record !== null && strength > 0;

const comesAgain = (gust: Gust): boolean => gust.amplitude > 0 && gust.repeat > 0;

/** Off a whole number, in turns. */
const offWhole = (turns: number): number => Math.abs(turns - Math.round(turns));

/**
 * The common period in seconds of what blows, where there is one of at most `most` seconds: the shortest time after which every wave, and the
 * record, has made whole turns, each but for `tolerance` turns. 0 where nothing moves, null where there is none.
 *
 * Gusts that pass once have no part in it, those that come again do. The model `sway` does not hear the waves: its own period is 4096 s, always.
 */
export function loopPeriod(wind: Wind, most = 600, tolerance = 0.005): number | null {
  if (wind.model === 'sway') return SWAY_SECONDS <= most ? SWAY_SECONDS : null;
  const rates = blowingWaves(wind)
    .filter((wave) => moves(wind, wave))
    .map((wave) => wave.speed / wave.wavelength);
  if (wind.record !== null && plays(wind)) rates.push(1 / recordSeconds(wind.record));
  for (const gust of wind.gusts) if (comesAgain(gust) && wind.strength > 0) rates.push(1 / gustRepeat(gust));
  if (rates.length === 0) return 0;
  const slowest = Math.min(...rates);
  const squares = rates.reduce((sum, rate) => sum + rate * rate, 0);
  for (let n = 1; n / slowest <= most * (1 + 1e-9); n++) {
    // The slowest makes n turns; the time that suits all best is near: least squares of what is off.
    const turns = rates.map((rate) => Math.round((n * rate) / slowest));
    const seconds = rates.reduce((sum, rate, i) => sum + rate * (turns[i] as number), 0) / squares;
    if (rates.every((rate, i) => Math.abs(rate * seconds - (turns[i] as number)) <= tolerance)) return seconds;
  }
  return null;
}

/** A part of the wind that does not come around in the time of a loop. */
export type LoopGap = 'gusts' | 'record' | 'sway';

/** A wind made to come around. */
export interface LoopedWind {
  wind: Wind;
  /** Largest relative change of the speed of a wave, of the record, or of gusts that come again, 0..: 0.1 is a tenth faster or slower. */
  change: number;
  /** What does not come around all the same; empty: the loop has no seam. */
  open: LoopGap[];
}

/**
 * The same wind with speeds nudged so that between `time` and `time + seconds` every wave makes whole turns (at least one, if it moves), its
 * crests being at `time` where they were: what a loop without a seam is recorded with, for a tree at `place`.
 *
 * Gusts that are felt in that time come again every `seconds`, once before it too, so that a tree with a memory (`spring`) is in the swing
 * of it; other gusts are left out. One that comes again within the loop does so a whole number of times. More than sixteen are too many: `open` says so. A record plays faster or slower so that it fits in whole
 * times; one that is longer than the loop stays open. `sway` has a period of its own (4096 s). A spring tree must have felt
 * this wind for some periods of its slowest branch before `time`. Throws a RangeError unless seconds > 0.
 */
export function loopWind(wind: Wind, seconds: number, time: number, place: Readonly<Placement> = ORIGIN): LoopedWind {
  if (!(seconds > 0)) throw new RangeError(`A loop lasts more than 0 seconds, not ${seconds}.`);
  let change = 0;
  const open: LoopGap[] = [];
  const changed = (factor: number): number => {
    change = Math.max(change, Math.abs(factor - 1));
    return factor;
  };
  const nudge = (turns: number): number => changed(Math.max(1, Math.round(turns)) / turns);
  const blowing = new Set(blowingWaves(wind));
  const waves = wind.waves.map((wave) => {
    if (!blowing.has(wave) || !moves(wind, wave)) return wave;
    const speed = wave.speed * nudge((wave.speed / wave.wavelength) * seconds);
    return rebaseWave(wave, { speed }, time);
  });
  let { record } = wind;
  if (record !== null && plays(wind)) {
    const times = seconds / recordSeconds(record);
    if (Math.round(times) >= 1) record = { ...record, step: record.step / nudge(times) };
    else open.push('record');
  }
  const [trains, single]: Gust[][] = [[], []];
  for (const gust of wind.gusts) {
    const times = comesAgain(gust) && Math.floor(seconds / gustRepeat(gust) + 1e-9) > 0 ? timesIn(gust, seconds) : 0;
    if (times === 0) single.push(...copiesWithin(gust, seconds, time, place));
    else if (firstFelt(gust, place) < time + seconds) {
      trains.push(train(gust, gustRepeat(gust) / changed((times * gustRepeat(gust)) / seconds), seconds, time, place));
    }
  }
  const gusts = [...trains, ...repeated(single, seconds, time, place)];
  if (gusts.length > MOST_GUSTS) open.push('gusts');
  if (wind.model === 'sway' && offWhole(seconds / SWAY_SECONDS) > 1e-9) open.push('sway');
  return { wind: { ...wind, waves, record, gusts: gusts.slice(0, MOST_GUSTS) }, change, open };
}

/** How often a gust comes in a loop that is no shorter than its repeat: a whole number of times, and never before the last one is over. */
function timesIn(gust: Gust, seconds: number): number {
  const nearest = Math.round(seconds / gustRepeat(gust));
  const repeat = seconds / nearest;
  return gustRepeat({ ...gust, repeat }) > repeat ? nearest - 1 : nearest;
}

/** The gust coming again every `repeat` seconds, at `time` where it was, for so long that a tree is in the swing of it. */
function train(gust: Gust, repeat: number, seconds: number, time: number, { x, y }: Readonly<Placement>): Gust {
  const came = Math.max(0, Math.floor((time - gustArrival(gust, x, y)) / gustRepeat(gust)));
  const start = gust.start + came * gustRepeat(gust);
  const early = Math.ceil((start - time + 2 * seconds + GUST_REACH / gust.speed) / repeat);
  return { ...gust, start: start - Math.max(0, early) * repeat, repeat };
}

/** When a gust comes to the first twig of a tree, seconds. */
const firstFelt = (gust: Gust, { x, y }: Readonly<Placement>): number =>
  gustArrival(gust, x, y) - TREE_REACH / gust.speed;

/** When it leaves the last twig, the first time that it comes. */
const lastFelt = (gust: Gust, { x, y }: Readonly<Placement>): number =>
  gustArrival(gust, x, y) + TREE_REACH / gust.speed + gust.rise + gust.fall;

/** A gust that comes again after a longer time than that of the loop, as the gusts that are felt within it, each once. */
function copiesWithin(gust: Gust, seconds: number, time: number, place: Readonly<Placement>): Gust[] {
  if (!comesAgain(gust)) return [gust];
  const repeat = gustRepeat(gust);
  const copies: Gust[] = [];
  for (let n = Math.max(0, Math.ceil((time - lastFelt(gust, place)) / repeat)); ; n++) {
    const copy = { ...gust, start: gust.start + n * repeat, repeat: 0 };
    if (firstFelt(copy, place) >= time + seconds) return copies;
    copies.push(copy);
  }
}

/** The gusts of a loop: those felt within it, and those copies of them that reach into it; then those of the period before. */
function repeated(gusts: readonly Gust[], seconds: number, time: number, place: Readonly<Placement>): Gust[] {
  const within: Gust[] = [];
  const before: Gust[] = [];
  for (const gust of gusts) {
    if (!(gust.amplitude > 0)) continue;
    const [first, last] = [firstFelt(gust, place), lastFelt(gust, place)];
    if (last <= time || first >= time + seconds) continue;
    // Copy n is felt from first + n seconds to last + n seconds.
    for (let n = Math.floor((time - seconds - last) / seconds) + 1; first + n * seconds < time + seconds; n++) {
      const copy = { ...gust, start: gust.start + n * seconds };
      (last + n * seconds > time ? within : before).push(copy);
    }
  }
  // The loop must come around; the period before is taken in as far as there is room.
  return within.length > MOST_GUSTS ? within : [...within, ...before].slice(0, MOST_GUSTS);
}
