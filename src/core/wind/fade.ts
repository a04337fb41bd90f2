import { appendWave, appendWaves, createForceUniforms, type ForceUniforms, type WaveUniforms } from './force.ts';
import { type BlowingGust, fillGusts } from './gust.ts';
import type { Placement } from './place.ts';
import { fillProfile } from './profile.ts';
import { fillRecord } from './record-state.ts';
import { sameBefore, sameValue } from './same-before.ts';
import {
  type BendModelName,
  blowingWaves,
  type Gust,
  type SpringSettings,
  STILL,
  type SwaySettings,
  type Wave,
  type Wind,
} from './wind.ts';

export { sameBefore } from './same-before.ts';

/** What the wind is at one time, as one tree feels it: what the passes take. */
export interface WindState extends WaveUniforms, Omit<ForceUniforms, keyof WaveUniforms> {
  /** Seconds. */
  time: number;
  forceExponent: number;
  lengthExponent: number;
  paper: boolean;
  /** Factor on every bend: one over the stiffness of the tree. */
  softness: number;
  /** The bend model that blows, or fades in. */
  model: BendModelName;
  /** The model that fades out, or null. */
  from: BendModelName | null;
  /** Weight of `model`, 0..1; `from` has the rest. */
  modelFade: number;
  /** Of the newest document at once: they change how a branch swings on from where it is. Not to be written to. */
  spring: SpringSettings;
  /** Speed and gust fade; where the frequencies differ, through 0. Overwritten by the next fill. */
  sway: SwaySettings;
  /** The wind's strength, 0..1: factor on what has a force of its own, as `sway` does. */
  loudness: number;
}

const smoothstep = (x: number): number => x * x * (3 - 2 * x);

const mix = (a: number, b: number, h: number): number => a + (b - a) * h;

/** A seek is at least so many seconds back: a fixed step may reach a little behind the time of an edit. */
const SEEK = 0.1;

/** Seconds that a fixed step may be ahead of the clock. */
const AHEAD = 0.04;

/**
 * The wind that blows now, fading from one document to the next: both blow at once, the old ever weaker, the new ever stronger,
 * so that no edit makes anything jump. An edit during a fade waits for its end; of several the latest wins. An edit that changes
 * nothing before its time (a gust thrown) needs no fade.
 *
 * Pure but for its queue: time is an argument, in seconds. A time before a fade began means that the clock was sought; the fade
 * is then over. Source: equations.md 5.6; Skjermo 2007 leaves parameter changes open.
 */
export class WindFader {
  #from: Wind;
  #to: Wind;
  #start = 0;
  #seconds = 0;
  #pending: { wind: Wind; seconds: number } | undefined;
  /** When the wind that blew became another than `#to` says of the past; undefined: never. */
  #edited: number | undefined;
  #epoch = 0;
  #place: Readonly<Placement> | undefined;

  constructor(wind: Wind) {
    this.#from = wind;
    this.#to = wind;
  }

  /** The document that the wind is, is becoming, or will become. */
  get target(): Wind {
    return this.#pending?.wind ?? this.#to;
  }

  /**
   * Another number whenever the past changed: a state that was run through time must be run again from time 0. A fade does not change it:
   * the state goes on from where it is, and its past is then another than that of the document, until the fader is settled.
   */
  get epoch(): number {
    return this.#epoch;
  }

  /** Lets `wind` blow: at once where `seconds` is 0 (as while paused), else after a fade of that many seconds from `time` on. */
  set(wind: Wind, time: number, seconds: number): void {
    if (!(seconds > 0)) {
      this.settle(wind, time);
      return;
    }
    this.#advance(time);
    if (sameBefore(this.target, wind, time + AHEAD, this.#place)) {
      if (this.#pending) this.#pending.wind = wind;
      else {
        if (this.#from === this.#to) this.#from = wind;
        this.#to = wind;
      }
      return;
    }
    if (this.#from !== this.#to) {
      this.#pending = { wind, seconds };
      return;
    }
    this.#to = wind;
    this.#start = time;
    this.#seconds = seconds;
    this.#edited ??= time;
  }

  /**
   * Ends every fade: the wind is, and has always been, `wind`, by default the latest that was asked for. What has been felt before `time`
   * stays valid where the two are the same until then, and no fade has gone before.
   */
  settle(wind = this.target, time = Number.POSITIVE_INFINITY): void {
    if (this.#edited !== undefined || !sameBefore(this.#to, wind, time + AHEAD, this.#place)) this.#epoch++;
    this.#edited = undefined;
    this.#from = wind;
    this.#to = wind;
    this.#pending = undefined;
  }

  /** Is a fade going on at `time`? */
  fading(time: number): boolean {
    this.#advance(time);
    return this.#from !== this.#to;
  }

  /** The wind at `time` seconds as a tree at `place` feels it; `out` is overwritten where it is given. */
  at(time: number, place?: Readonly<Placement>, out: WindState = createWindState()): WindState {
    this.#place = place;
    this.#advance(time);
    if (this.#from === this.#to) return windStateAt(this.#to, time, place, out);
    const h = smoothstep(Math.max(0, (time - this.#start) / this.#seconds));
    return crossFade(this.#from, this.#to, h, time, place, out);
  }

  #advance(time: number): void {
    if (this.#edited !== undefined && time < this.#edited - SEEK) this.settle();
    while (this.#from !== this.#to) {
      const end = this.#start + this.#seconds;
      if (time < end) return;
      this.#from = this.#to;
      if (this.#pending === undefined) return;
      this.#to = this.#pending.wind;
      this.#seconds = this.#pending.seconds;
      this.#start = end;
      this.#pending = undefined;
    }
  }
}

export const createWindState = (): WindState => ({
  ...createForceUniforms(),
  time: 0,
  forceExponent: 1,
  lengthExponent: 1,
  paper: false,
  softness: 1,
  model: 'direct',
  from: null,
  modelFade: 1,
  spring: STILL.spring,
  sway: { ...STILL.sway },
  loudness: 1,
});

/** The state of one wind at `time` seconds as a tree at `place` feels it, without fading; `out` is overwritten where it is given. */
export function windStateAt(
  wind: Wind,
  time: number,
  place?: Readonly<Placement>,
  out: WindState = createWindState(),
): WindState {
  fillSettings(out, wind, wind, 1, time);
  out.count = 0;
  appendWaves(out, wind, time, 1, place);
  clearRest(out);
  const gusts = wind.gusts.map((gust) => ({ gust, peak: gust.amplitude * wind.strength }));
  fillGusts(out, gusts, time, place);
  fillRecord(out, wind.record, wind.strength, time, place);
  return out;
}

/** The state between two winds: all of the old at 1 - h and all of the new at h of its strength. */
function crossFade(
  from: Wind,
  to: Wind,
  h: number,
  time: number,
  place: Readonly<Placement> | undefined,
  out: WindState,
): WindState {
  fillSettings(out, from, to, h, time);
  fadeWaves(from, to, h, time, place, out);
  fillGusts(out, fadeGusts(from, to, h), time, place);
  if (from.record === to.record || sameValue(from.record, to.record)) {
    fillRecord(out, to.record, mix(from.strength, to.strength, h), time, place);
  } else {
    // One texture holds one record: the old is gone when the new begins.
    const first = h < 0.5;
    fillRecord(out, first ? from.record : to.record, Math.abs(1 - 2 * h) * (first ? from : to).strength, time, place);
  }
  return out;
}

/** What is not force, and the profile, which is a factor on it. */
function fillSettings(out: WindState, from: Wind, to: Wind, h: number, time: number): void {
  out.time = time;
  out.paper = to.paper;
  out.forceExponent = mix(from.forceExponent, to.forceExponent, h);
  out.lengthExponent = mix(from.lengthExponent, to.lengthExponent, h);
  out.softness = mix(1 / from.stiffness, 1 / to.stiffness, h);
  out.model = to.model;
  out.from = from.model === to.model ? null : from.model;
  out.modelFade = out.from === null ? 1 : h;
  out.loudness = mix(from.strength, to.strength, h);
  out.spring = to.spring;
  fadeSway(out, from, to, h);
  fillProfile(out, to.profile, from.profile, h);
}

/** A phase cannot go from one frequency to another: where they differ, the tree stands still in between. */
function fadeSway(out: WindState, from: Wind, to: Wind, h: number): void {
  const { sway } = out;
  // While a model fades, the other one's settings do not matter: the swaying one keeps its own all the while.
  const [a, b] = [from.model === 'sway' ? from.sway : to.sway, to.model === 'sway' ? to.sway : from.sway];
  const alike = a.reading === b.reading && a.rate === b.rate;
  const late = alike || h >= 0.5;
  sway.reading = (late ? b : a).reading;
  sway.rate = (late ? b : a).rate;
  const through = alike ? 1 : Math.abs(1 - 2 * h);
  sway.speed = (alike ? mix(a.speed, b.speed, h) : (late ? b : a).speed) * through;
  sway.gust = (alike ? mix(a.gust, b.gust, h) : (late ? b : a).gust) * through;
}

/** Do two waves differ in strength alone? Then one wave of the mixed strength is their cross-fade. */
const alike = (a: Wave, b: Wave): boolean =>
  a.direction === b.direction &&
  a.wavelength === b.wavelength &&
  a.speed === b.speed &&
  a.sharpness === b.sharpness &&
  a.phase === b.phase;

/** The waves of both winds; one that both have takes one slot, with the peaks added and the means weighted by them. */
function fadeWaves(
  from: Wind,
  to: Wind,
  h: number,
  time: number,
  place: Readonly<Placement> | undefined,
  out: WindState,
): void {
  out.count = 0;
  const old = blowingWaves(from);
  for (const wave of blowingWaves(to)) {
    const rising = wave.amplitude * to.strength * h;
    const i = from.paper === to.paper ? old.findIndex((other) => alike(wave, other)) : -1;
    const fading = i < 0 ? 0 : (old[i] as Wave).amplitude * from.strength * (1 - h);
    if (i >= 0) old.splice(i, 1);
    const peak = rising + fading;
    const mean = ((to.zeroMean ? rising : 0) + (from.zeroMean ? fading : 0)) / peak;
    appendWave(out, wave, peak, mean, to.paper, time, place);
  }
  for (const wave of old) {
    appendWave(out, wave, wave.amplitude * from.strength * (1 - h), from.zeroMean ? 1 : 0, from.paper, time, place);
  }
  clearRest(out);
}

/** The shader sums every slot: those not in use must push nothing. */
function clearRest({ count, waves, phases }: WaveUniforms): void {
  waves.fill(0, 4 * count);
  phases.fill(0, 4 * count);
}

/** The gusts of both winds; one that both have is there once. */
function fadeGusts(from: Wind, to: Wind, h: number): BlowingGust[] {
  const gusts: BlowingGust[] = to.gusts.map((gust) => ({ gust, peak: gust.amplitude * to.strength * h }));
  from.gusts.forEach((gust) => {
    const peak = gust.amplitude * from.strength * (1 - h);
    const other = gusts.find((blowing) => alikeGusts(blowing.gust, gust));
    if (other) other.peak += peak;
    else gusts.push({ gust, peak });
  });
  return gusts;
}

const alikeGusts = (a: Gust, b: Gust): boolean => a === b || sameValue({ ...a, amplitude: b.amplitude }, b);
