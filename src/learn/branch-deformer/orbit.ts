import type { FigureHost } from '../figure.ts';
import { OrbitHand } from '../orbit-hand.ts';
import type { Eye } from './solid.ts';

/** Where the reader stands: from a first yaw and pitch in radians, turned by dragging the stage or with the arrow keys. */
export class Orbit {
  readonly #hand: OrbitHand;
  readonly #yaw: number;
  readonly #pitch: number;

  constructor(host: FigureHost, yaw: number, pitch: number) {
    this.#yaw = yaw;
    this.#pitch = pitch;
    this.#hand = new OrbitHand(host.canvas, () => host.redraw());
  }

  reset(): void {
    this.#hand.reset();
  }

  get angles(): Pick<Eye, 'yaw' | 'pitch'> {
    return { yaw: this.#yaw + this.#hand.azimuth, pitch: Math.min(1.5, this.#pitch + this.#hand.elevation) };
  }
}
