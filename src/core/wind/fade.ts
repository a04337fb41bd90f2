import { appendWaves, createWaveUniforms, type Placement, type WaveUniforms } from './force.ts';
import type { Wave, Wind } from './wind.ts';

/** What the wind is at one time: the waves, and the exponents, which fade with them. */
export interface WindState extends WaveUniforms {
  forceExponent: number;
  lengthExponent: number;
  paper: boolean;
}

const smoothstep = (x: number): number => x * x * (3 - 2 * x);

/** Do two waves differ in strength alone? Then one wave of the mixed strength is their cross-fade. */
const alike = (a: Wave, b: Wave): boolean =>
  a.direction === b.direction &&
  a.wavelength === b.wavelength &&
  a.speed === b.speed &&
  a.sharpness === b.sharpness &&
  a.phase === b.phase;

const peak = (wave: Wave, wind: Wind): number => (wave.on ? wave.amplitude * wind.strength : 0);

/**
 * The wind that blows now, fading from one document to the next: both blow at once, the old ever weaker, the new ever stronger,
 * so that no edit makes anything jump. An edit during a fade waits for its end; of several the latest wins.
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

  constructor(wind: Wind) {
    this.#from = wind;
    this.#to = wind;
  }

  /** The document that the wind is, is becoming, or will become. */
  get target(): Wind {
    return this.#pending?.wind ?? this.#to;
  }

  /** Lets `wind` blow: at once where `seconds` is 0 (as while paused), else after a fade of that many seconds from `time` on. */
  set(wind: Wind, time: number, seconds: number): void {
    if (!(seconds > 0)) {
      this.settle(wind);
      return;
    }
    this.#advance(time);
    if (this.#from !== this.#to) {
      this.#pending = { wind, seconds };
      return;
    }
    this.#to = wind;
    this.#start = time;
    this.#seconds = seconds;
  }

  /** Ends every fade: the wind is `wind`, by default the latest that was asked for. */
  settle(wind = this.target): void {
    this.#from = wind;
    this.#to = wind;
    this.#pending = undefined;
  }

  /** Is a fade going on at `time`? */
  fading(time: number): boolean {
    this.#advance(time);
    return this.#from !== this.#to;
  }

  /** The waves at `time` seconds as a tree at `place` feels them; `out` is overwritten where it is given. */
  at(time: number, place?: Placement, out: WindState = createWindState()): WindState {
    this.#advance(time);
    const from = this.#from;
    const to = this.#to;
    if (from === to) return windStateAt(to, time, place, out);
    const h = smoothstep((time - this.#start) / this.#seconds);
    out.count = 0;
    out.paper = to.paper;
    out.forceExponent = from.forceExponent + (to.forceExponent - from.forceExponent) * h;
    out.lengthExponent = from.lengthExponent + (to.lengthExponent - from.lengthExponent) * h;
    const [fading, rising] = crossFade(from, to, h);
    appendWaves(out, rising, time, 1, place);
    appendWaves(out, fading, time, 1, place);
    return out;
  }

  #advance(time: number): void {
    while (this.#from !== this.#to) {
      if (time < this.#start) {
        this.settle();
        return;
      }
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
  ...createWaveUniforms(),
  forceExponent: 1,
  lengthExponent: 1,
  paper: false,
});

/** The state of one wind at `time` seconds as a tree at `place` feels it, without fading; `out` is overwritten where it is given. */
export function windStateAt(
  wind: Wind,
  time: number,
  place?: Placement,
  out: WindState = createWindState(),
): WindState {
  out.count = 0;
  out.paper = wind.paper;
  out.forceExponent = wind.forceExponent;
  out.lengthExponent = wind.lengthExponent;
  return appendWaves(out, wind, time, 1, place);
}

/** The old wind at 1 - h and the new one at h of their strength; a wave that both have is in the new one alone. */
function crossFade(from: Wind, to: Wind, h: number): [fading: Wind, rising: Wind] {
  const fading: Wave[] = [];
  const rising = to.waves.map((wave) => ({ ...wave, on: true, amplitude: peak(wave, to) * h }));
  from.waves.forEach((wave, i) => {
    const amplitude = peak(wave, from) * (1 - h);
    const other = rising[i];
    if (other !== undefined && from.paper === to.paper && alike(wave, other)) other.amplitude += amplitude;
    else fading.push({ ...wave, on: true, amplitude });
  });
  return [
    { ...from, strength: 1, waves: fading },
    { ...to, strength: 1, waves: rising },
  ];
}
