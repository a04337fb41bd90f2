import { type RoundsTimed, timedRounds } from '../../gpu/timed-rounds.ts';
import type { Kind, Row } from './measured.ts';

/** One size to measure, ready to run. */
export interface Work {
  run(): void;
  done(): Promise<void>;
  dispose(): void;
}

/** A kind of work, its sizes from small to large, and how one is made ready. */
export interface Series {
  readonly kind: Kind;
  readonly sizes: readonly number[];
  prepare(size: number): Promise<Work>;
}

/** Milliseconds that one run may take: a size that would take longer is left out, and so are the larger ones. */
export const LONGEST = 900;

/** How much longer the next size should take at most: work grows no faster than its size. */
const foreseen = (taken: number, size: number, next: number): number => (taken * next) / size;

export interface Telling {
  /** A size is about to be measured. */
  doing(kind: Kind, size: number): void;
  found(row: Row): void;
}

/** Measures all series one after the other, small sizes first. Rejects with the signal's reason where it is aborted. */
export async function runAll(
  series: readonly Series[],
  { doing, found }: Telling,
  signal: AbortSignal,
  time: (work: Work, signal: AbortSignal) => Promise<RoundsTimed> = (work, stop) =>
    timedRounds(
      () => work.run(),
      () => work.done(),
      { signal: stop },
    ),
): Promise<void> {
  for (const { kind, sizes, prepare } of series) {
    let last: { readonly size: number; readonly taken: number } | null = null;
    for (const size of sizes) {
      if (last && foreseen(last.taken, last.size, size) > LONGEST) {
        found({ kind, size, milliseconds: null, unrest: null });
        continue;
      }
      doing(kind, size);
      signal.throwIfAborted();
      const work = await prepare(size);
      try {
        const { median, least } = await time(work, signal);
        last = { size, taken: median };
        found({ kind, size, milliseconds: median, unrest: median / least });
      } finally {
        work.dispose();
      }
    }
  }
}
