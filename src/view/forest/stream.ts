/** Something that may be grown and kept on the GPU, as it is wanted in a frame. */
export interface Wish {
  /** Names it. */
  readonly key: string;
  readonly inView: boolean;
  /** How much it is missed: its size on screen over that from which it is wanted. */
  readonly urgency: number;
  /** What it takes, or would. */
  readonly bytes: number;
}

/** What is to be done in a frame. */
export interface Plan {
  /** To be grown, the most urgent first. */
  readonly grow: readonly string[];
  /** Being grown and no longer wanted. */
  readonly cancel: readonly string[];
  /** There, and to be freed. */
  readonly drop: readonly string[];
}

interface Unit {
  state: 'growing' | 'there';
  bytes: number;
  /** Number of the frame in which it was wanted last. */
  wanted: number;
}

/** Things that are grown at the same time: one in the worker, one waiting behind it. */
const IN_FLIGHT = 2;

/**
 * Which groves are grown, kept and freed: what is in view first and of that what is missed most, as much as memory holds. What is no
 * longer wanted stays until memory asks for it, the longest unwanted first.
 */
export class Stream {
  readonly #units = new Map<string, Unit>();
  /** What something really takes, once it has been there: a guess that was too low would have it grown and freed again and again. */
  readonly #known = new Map<string, number>();
  #frame = 0;

  /** Bytes of what is there. */
  get bytes(): number {
    let sum = 0;
    for (const { state, bytes } of this.#units.values()) if (state === 'there') sum += bytes;
    return sum;
  }

  get growing(): number {
    let sum = 0;
    for (const { state } of this.#units.values()) if (state === 'growing') sum++;
    return sum;
  }

  /** What to do so that as many wishes as possible come true within `budget` bytes. */
  plan(wishes: readonly Wish[], budget: number): Plan {
    const frame = ++this.#frame;
    const sorted = [...wishes].sort((a, b) => Number(b.inView) - Number(a.inView) || b.urgency - a.urgency);
    const granted: Wish[] = [];
    let sum = 0;
    for (const wish of sorted) {
      const bytes = this.#known.get(wish.key) ?? wish.bytes;
      if (bytes > budget) continue; // it never fits
      // A smaller one behind it would take its place and be thrown out again as soon as it is nearer.
      if (sum + bytes > budget) break;
      sum += bytes;
      granted.push(wish);
    }
    for (const { key } of granted) {
      const unit = this.#units.get(key);
      if (unit) unit.wanted = frame;
    }
    const cancel: string[] = [];
    let growing = 0;
    for (const [key, { state, wanted }] of this.#units) {
      if (state !== 'growing') continue;
      if (wanted === frame) growing++;
      else cancel.push(key);
    }
    for (const key of cancel) this.#units.delete(key);
    const grow: string[] = [];
    for (const { key, bytes } of granted) {
      if (growing >= IN_FLIGHT) break;
      if (this.#units.has(key)) continue;
      this.#units.set(key, { state: 'growing', bytes, wanted: frame });
      grow.push(key);
      growing++;
    }
    return { grow, cancel, drop: this.#spare(frame, budget) };
  }

  /** Something is there now. */
  arrived(key: string, bytes: number): void {
    this.#known.set(key, bytes);
    this.#units.set(key, { state: 'there', bytes, wanted: this.#frame });
  }

  /** Growing it came to nothing: it may be asked for again. */
  failed(key: string): void {
    this.#units.delete(key);
  }

  /** All is forgotten, as when another forest comes. */
  clear(): void {
    this.#units.clear();
    this.#known.clear();
  }

  /** Frees what was wanted longest ago, until what is there and what comes fits. */
  #spare(frame: number, budget: number): string[] {
    let sum = 0;
    for (const { bytes } of this.#units.values()) sum += bytes;
    const idle = [...this.#units].filter(([, { state, wanted }]) => state === 'there' && wanted < frame);
    idle.sort(([, a], [, b]) => a.wanted - b.wanted);
    const drop: string[] = [];
    for (const [key, { bytes }] of idle) {
      if (sum <= budget) break;
      sum -= bytes;
      this.#units.delete(key);
      drop.push(key);
    }
    return drop;
  }
}
