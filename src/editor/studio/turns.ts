/** Something that is drawn again and again. */
interface Turn {
  readonly draw: () => void;
  /** When it was drawn last, and what that took lately; milliseconds. */
  last: number;
  cost: number;
  wanted: boolean;
  /** Milliseconds from one drawing to the next, at least. */
  readonly interval: number;
}

/**
 * Lets many plots share a few milliseconds a frame: each asks to be drawn as often as it likes, and has its turn at most so many
 * times a second, the one that waited longest first, for as long as the frame's share lasts. One is always drawn.
 */
export class Turns {
  readonly #now: () => number;
  readonly #turns: Turn[] = [];
  /** Milliseconds of a frame that may be spent. */
  readonly budget: number;

  constructor(now: () => number, budget = 1.5) {
    this.#now = now;
    this.budget = budget;
  }

  /** Adds something to draw at most `rate` times a second; returns what asks for a turn and what takes it away again. */
  add(draw: () => void, rate = 25): { ask: () => void; remove: () => void } {
    const turn: Turn = { draw, last: Number.NEGATIVE_INFINITY, cost: 0, wanted: false, interval: 1000 / rate };
    this.#turns.push(turn);
    return {
      ask: () => {
        turn.wanted = true;
      },
      remove: () => {
        const at = this.#turns.indexOf(turn);
        if (at >= 0) this.#turns.splice(at, 1);
      },
    };
  }

  /** All of them want a turn. */
  askAll(): void {
    for (const turn of this.#turns) turn.wanted = true;
  }

  /** Is one still waiting? */
  get waiting(): boolean {
    return this.#turns.some((turn) => turn.wanted);
  }

  /** Once a frame: draws those whose turn it is. `hurry`: all that wait, whatever it takes. Returns the milliseconds spent. */
  run(hurry = false): number {
    const start = this.#now();
    // A frame at 60 Hz comes a little early or late: two milliseconds are no reason to wait for another one.
    const due = this.#turns.filter((turn) => turn.wanted && (hurry || start - turn.last >= turn.interval - 2));
    due.sort((a, b) => a.last - b.last);
    let at = start;
    for (const turn of due) {
      if (!hurry && at > start && at - start + turn.cost > this.budget) break;
      turn.wanted = false;
      turn.draw();
      const end = this.#now();
      turn.cost = turn.last === Number.NEGATIVE_INFINITY ? end - at : turn.cost + 0.2 * (end - at - turn.cost);
      turn.last = start;
      at = end;
    }
    return at - start;
  }
}
