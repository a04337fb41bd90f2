import type { Matrix4 } from 'three';
import { sameBefore, WindFader, type WindState } from '../core/wind/fade.ts';
import type { Placement } from '../core/wind/place.ts';
import { STILL, type Wind } from '../core/wind/wind.ts';
import type { WindSource } from '../gpu/wind-source.ts';

/** Seconds that the wind pass may be ahead of the clock. */
const AHEAD = 0.04;

/** A wind that nobody else can change: else one that was written to would blow without having been set, and its past be another. */
const copyOf = (wind: Wind): Wind => ({ ...structuredClone({ ...wind, record: null }), record: wind.record });

/** The wind as one tree in a scene feels it: a document that fades into the next, from where the tree stands and as it is turned. */
export class FeltWind implements WindSource {
  revision = 1;
  past = 1;
  #fader = new WindFader(STILL);
  readonly #place: Placement = { x: 0, y: 0, yaw: 0 };
  /** Counts what the fader knows nothing of: other places. */
  #moves = 0;
  /** Nothing has been posed by it yet: what comes first has always been so. */
  #fresh = true;

  get pose(): Wind['pose'] {
    return this.#fader.target.pose;
  }

  /** The document that blows or is fading in. */
  get wind(): Wind {
    return this.#fader.target;
  }

  /** Metres from where the tree stands to the farthest of its twigs: gusts that start farther away change nothing that was. */
  set reach(metres: number) {
    this.#place.reach = metres;
  }

  get epoch(): number {
    return this.#fader.epoch + this.#moves;
  }

  set(wind: Wind, time: number, seconds: number): void {
    const { epoch } = this;
    const own = copyOf(wind);
    const same = sameBefore(this.wind, own, time + AHEAD, this.#place);
    this.#fader.set(own, time, this.#fresh ? 0 : seconds);
    if (!same || this.epoch !== epoch) this.past++;
    this.revision++;
  }

  /** Takes place and yaw from a y-up world matrix: the wind travels over the world's ground, not over the tree's own. */
  moveTo({ elements }: Matrix4): void {
    const x = elements[12] as number;
    const y = -(elements[14] as number);
    const yaw = Math.atan2(-(elements[2] as number), elements[0] as number);
    const place = this.#place;
    if (place.x === x && place.y === y && place.yaw === yaw) return;
    Object.assign(place, { x, y, yaw });
    // A tree that is carried along swings on from where it is; one that was just set down has always stood there.
    if (this.#fresh) this.#moves++;
    this.past++;
    this.revision++;
  }

  fill(time: number, out: WindState): void {
    this.#fresh = false;
    this.#fader.at(time, this.#place, out);
  }
}
