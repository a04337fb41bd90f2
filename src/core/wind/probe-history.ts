/** What a probe feels and does at one step. Tree space, metres. */
export interface ProbeReading {
  /** Force of the wind where the branch feels it. */
  fx: number;
  fy: number;
  /** Displacement of the end of the piece from its rest. */
  x: number;
  y: number;
  z: number;
}

/** The columns that plots, tables and files are made of. */
export type ProbeColumn =
  | 'time'
  | 'force'
  | 'forceAlong'
  | 'forceAcross'
  | 'along'
  | 'across'
  | 'up'
  | 'velocityAlong'
  | 'velocityAcross';

/** Steps of the clock a second: the state of the wind lives on them. */
export const PROBE_RATE = 60;

/** Numbers of one reading. */
const WIDTH = 5;

/** The last readings of a probe, one a step, oldest first: a ring that forgets what is older than `capacity` steps. */
export class ProbeHistory {
  readonly capacity: number;
  readonly #data: Float64Array;
  #count = 0;
  #last = -1;
  #revision = 0;

  /** `capacity`: readings that are kept, >= 2. */
  constructor(capacity = 60 * PROBE_RATE + 1) {
    this.capacity = capacity;
    this.#data = new Float64Array(WIDTH * capacity);
  }

  /** Readings that there are. */
  get count(): number {
    return this.#count;
  }

  /** Step of the oldest reading; with `count` 0 there is none. */
  get first(): number {
    return this.#last - this.#count + 1;
  }

  /** Step of the newest reading, -1 where there is none. */
  get last(): number {
    return this.#count > 0 ? this.#last : -1;
  }

  /** Another number whenever a reading was added or lost. */
  get revision(): number {
    return this.#revision;
  }

  clear(): void {
    this.#revision++;
    this.#count = 0;
    this.#last = -1;
  }

  /** Forgets what is newer than `step`. */
  cut(step: number): void {
    if (step >= this.#last) return;
    this.#revision++;
    this.#count = Math.max(0, this.#count - (this.#last - step));
    this.#last = this.#count > 0 ? step : -1;
  }

  /** Adds the reading of `step`; where that is not the one after the last, the others are forgotten. */
  push(step: number, reading: ProbeReading): void {
    if (step !== this.#last + 1) this.clear();
    this.#revision++;
    this.#last = step;
    this.#count = Math.min(this.capacity, this.#count + 1);
    const at = this.#at(step);
    this.#data[at] = reading.fx;
    this.#data[at + 1] = reading.fy;
    this.#data[at + 2] = reading.x;
    this.#data[at + 3] = reading.y;
    this.#data[at + 4] = reading.z;
  }

  /** The reading of `step`, or null where there is none. */
  reading(step: number): ProbeReading | null {
    if (this.#count === 0 || step < this.first || step > this.#last) return null;
    const at = this.#at(step);
    const data = this.#data;
    return { fx: data[at], fy: data[at + 1], x: data[at + 2], y: data[at + 3], z: data[at + 4] };
  }

  /**
   * A column of the last `steps` readings (all by default), oldest first. `axis`: the direction that `along` means, radians from x to
   * y; across is to its left. Force in metres, displacement in metres, velocity in metres a second (central differences, one-sided
   * at the ends), time in seconds.
   */
  column(name: ProbeColumn, axis: number, steps = this.#count): Float64Array {
    const n = Math.min(steps, this.#count);
    const out = new Float64Array(n);
    const start = this.#last - n + 1;
    const cos = Math.cos(axis);
    const sin = Math.sin(axis);
    const part = (offset: number, x: number, y: number): void => {
      for (let i = 0; i < n; i++) {
        const at = this.#at(start + i) + offset;
        out[i] = x * this.#data[at] + y * this.#data[at + 1];
      }
    };
    if (name === 'time') for (let i = 0; i < n; i++) out[i] = (start + i) / PROBE_RATE;
    else if (name === 'forceAlong') part(0, cos, sin);
    else if (name === 'forceAcross') part(0, -sin, cos);
    else if (name === 'along') part(2, cos, sin);
    else if (name === 'across') part(2, -sin, cos);
    else if (name === 'up') part(4, 1, 0);
    else if (name === 'velocityAlong') return derivative(this.column('along', axis, n));
    else if (name === 'velocityAcross') return derivative(this.column('across', axis, n));
    else {
      for (let i = 0; i < n; i++) {
        const at = this.#at(start + i);
        out[i] = Math.hypot(this.#data[at], this.#data[at + 1]);
      }
    }
    return out;
  }

  #at(step: number): number {
    return WIDTH * (step % this.capacity);
  }
}

/** Change a second of values that are a step apart. */
function derivative(values: Float64Array): Float64Array {
  const n = values.length;
  const out = new Float64Array(n);
  for (let i = 0; i < n; i++) {
    const a = Math.max(0, i - 1);
    const b = Math.min(n - 1, i + 1);
    out[i] = b > a ? ((values[b] - values[a]) * PROBE_RATE) / (b - a) : 0;
  }
  return out;
}
