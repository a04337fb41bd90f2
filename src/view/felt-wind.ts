import type { Matrix4 } from 'three';
import { WindFader, type WindState } from '../core/wind/fade.ts';
import type { Placement } from '../core/wind/force.ts';
import { presets } from '../core/wind/presets.ts';
import type { Wind } from '../core/wind/wind.ts';
import type { WindSource } from '../gpu/wind-source.ts';

/** The wind as one tree in a scene feels it: a document that fades into the next, from where the tree stands and as it is turned. */
export class FeltWind implements WindSource {
  revision = 1;
  #fader = new WindFader(presets.still as Wind);
  readonly #place: Placement = { x: 0, y: 0, yaw: 0 };

  get pose(): Wind['pose'] {
    return this.#fader.target.pose;
  }

  /** The document that blows or is fading in. */
  get wind(): Wind {
    return this.#fader.target;
  }

  set(wind: Wind, time: number, seconds: number): void {
    this.#fader.set(wind, time, seconds);
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
    this.revision++;
  }

  fill(time: number, out: WindState): void {
    this.#fader.at(time, this.#place, out);
  }
}
