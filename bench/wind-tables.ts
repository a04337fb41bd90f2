import type { Timing } from '../src/gpu/interleave.ts';
import type { BenchReport } from './report.ts';

/** What the page of the wind pass writes; the first timing of a row is the floor. */
export interface WindTimings {
  readonly renderer: string;
  readonly rows: readonly {
    readonly pieces: number;
    readonly depths: number;
    readonly timings: readonly Timing[];
    /** The bend models beside each other; the first is the paper's. */
    readonly models: readonly Timing[];
  }[];
}

/** The timings of the wind pass as tables: milliseconds, and times of the floor. */
export function windReport({ renderer, rows }: WindTimings): BenchReport {
  const names = rows[0]!.timings.map(({ name }) => name);
  const floor = names[0]!;
  const models = rows[0]!.models.map(({ name }) => name);
  return {
    title: 'Wind pass',
    renderer,
    tables: [
      {
        caption: 'Milliseconds a step, median',
        columns: ['pieces', 'depths', ...names],
        rows: rows.map(({ pieces, depths, timings }) => [pieces, depths, ...timings.map((each) => each.median)]),
      },
      {
        caption: `Times of the ${floor}, median of rounds in turn; aim: at most 1.6`,
        columns: ['pieces', ...names.slice(1)],
        rows: rows.map(({ pieces, timings }) => [pieces, ...timings.slice(1).map(({ ratio }) => ratio)]),
      },
      {
        caption: 'Microseconds a piece: the cost grows linearly where a column stays level',
        columns: ['pieces', ...names],
        rows: rows.map(({ pieces, timings }) => [pieces, ...timings.map((each) => (1000 * each.median) / pieces)]),
      },
      {
        caption:
          'Bend models, exact, milliseconds a step, and times of direct; aim: at most 1.5 for spring at 65 536 pieces',
        columns: ['pieces', ...models, ...models.slice(1).map((name) => `${name} / direct`)],
        rows: rows.map((row) => [
          row.pieces,
          ...row.models.map((each) => each.median),
          ...row.models.slice(1).map((each) => each.ratio),
        ]),
      },
    ],
  };
}
