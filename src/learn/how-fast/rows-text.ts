import type { Row } from './measured.ts';
import { words } from './words.ts';

/** How long a size that was left out would take, by the largest of its kind that was measured: seconds. */
export function wouldTake(rows: readonly Row[], { kind, size }: Row): number {
  const last = rows.filter((row) => row.kind === kind && row.milliseconds !== null).at(-1);
  return last ? ((last.milliseconds as number) * size) / last.size / 1000 : Number.NaN;
}

/** A row as the cells of the table; one that was left out has a sentence in place of its figures. */
export function cellsOf(row: Row, rows: readonly Row[]): string[] {
  const { kind, size, milliseconds, unrest } = row;
  if (milliseconds === null) return [words.kinds[kind], words.size(size), words.skipped(wouldTake(rows, row))];
  const rate = 1000 / milliseconds;
  return [
    words.kinds[kind],
    words.size(size),
    milliseconds.toPrecision(3),
    rate >= 100 ? rate.toFixed(0) : rate.toPrecision(3),
    unrest === null ? '' : unrest.toFixed(2),
  ];
}

/** The rows as comma-separated values, numbers in full; the renderer in each, so that files of several machines can be joined. */
export function csvOf(rows: readonly Row[], renderer: string): string {
  const quoted = (text: string): string => `"${text.replaceAll('"', '""')}"`;
  const lines = rows.map(({ kind, size, milliseconds, unrest }) =>
    [
      kind,
      size,
      milliseconds ?? '',
      milliseconds === null ? '' : 1000 / milliseconds,
      unrest ?? '',
      quoted(renderer),
    ].join(),
  );
  return ['kind,size,milliseconds,per_second,median_by_least,renderer', ...lines, ''].join('\r\n');
}
