import type { Table } from '../../bench/report.ts';

/** A picture of what was measured. */
export interface Picture {
  readonly name: string;
  readonly url: string;
}

/** What a part of the benchmark hands over. */
export interface Found {
  readonly table: Table;
  readonly pictures: readonly Picture[];
}

/** What a part of the benchmark works with. */
export interface Bench {
  /** A canvas of its own, 16 : 9. */
  readonly canvas: HTMLCanvasElement;
  /** Rounds of each timing, and trees of the larger parts: fewer where the machine is slow. */
  readonly rounds: number;
  readonly milliseconds: number;
  readonly trees: number;
  readonly counts: readonly number[];
  /** Says what is done, and lets the page breathe. Throws StopAsked where the reader has asked for it. */
  step(text: string): Promise<void>;
  readonly signal: AbortSignal;
}

export interface Section {
  readonly id: string;
  readonly title: string;
  readonly lead: string;
  run(bench: Bench): Promise<Found>;
}

/** The reader has pressed Stop. */
export class StopAsked extends Error {
  override readonly name = 'StopAsked';
}

/** Size of what is drawn, pixels. */
export const SIZE = [960, 540] as const;
