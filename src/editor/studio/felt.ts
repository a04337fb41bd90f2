import { createWindState, WindFader, type WindState, windStateAt } from '../../core/wind/fade.ts';
import type { ProbeWind } from '../../core/wind/probe.ts';
import type { Wind } from '../../core/wind/wind.ts';

/** The wind of a document as the tree feels it, fades included: what the picture has too, without its GPU. */
export class FeltByProbe implements ProbeWind {
  readonly #fader: WindFader;
  /** The fader knows what blew from here on, seconds; before it, the newest wind is taken to have blown always. */
  #since = Number.NEGATIVE_INFINITY;

  constructor(wind: Wind) {
    this.#fader = new WindFader(wind);
  }

  get wind(): Wind {
    return this.#fader.target;
  }

  /** Another number whenever the past changed (see WindFader). */
  get epoch(): number {
    return this.#fader.epoch;
  }

  /** Tells what the clock says: where that is before the last edit, the past becomes that of the newest wind. */
  follow(time: number): void {
    const before = this.#fader.epoch;
    this.#fader.fading(time);
    if (this.#fader.epoch !== before) this.#since = Number.NEGATIVE_INFINITY;
  }

  /** Asking for the past changes nothing, as it would with the fader alone, which would take it for a seek. */
  at(time: number, out: WindState = createWindState()): WindState {
    if (time < this.#since) return windStateAt(this.wind, time, undefined, out);
    return this.#fader.at(time, undefined, out);
  }

  /** As `Picture.setWind`, at `time`. */
  set(wind: Wind, time: number, fade: number): void {
    this.#fader.set(wind, time, fade);
    this.#since = fade > 0 ? time : Number.NEGATIVE_INFINITY;
  }
}
