import { PROBE_RATE, type ProbeHistory } from '../../core/wind/probe-history.ts';
import { rootMeanSquare } from '../../core/wind/probe-summary.ts';
import type { NumberTable } from './csv.ts';

/** The probe's displacement in two winds at the same times, and B less A; metres along one direction. */
export interface Compared {
  /** Seconds. */
  readonly time: Float64Array;
  readonly a: Float64Array;
  readonly b: Float64Array;
  readonly difference: Float64Array;
}

/** The last `seconds` that both histories hold; `axis`: the direction of `along`, radians. */
export function compare(a: ProbeHistory, b: ProbeHistory, axis: number, seconds: number): Compared {
  const last = Math.min(a.last, b.last);
  const first = Math.max(a.first, b.first, last - seconds * PROBE_RATE);
  const part = (history: ProbeHistory, name: 'time' | 'along'): Float64Array => {
    const column = history.column(name, axis);
    const start = first - history.first;
    return column.slice(start, start + Math.max(0, last - first + 1));
  };
  if (a.count === 0 || b.count === 0 || last < first) {
    const none = new Float64Array(0);
    return { time: none, a: none, b: none, difference: none };
  }
  const [x, y] = [part(a, 'along'), part(b, 'along')];
  return { time: part(a, 'time'), a: x, b: y, difference: y.map((value, i) => value - x[i]!) };
}

/** Root mean square and greatest of the difference, and of A, against which it is to be seen; metres. null of nothing. */
export function differenceOf({ a, difference }: Compared): { rms: number; greatest: number; of: number } | null {
  if (difference.length < 2) return null;
  return {
    rms: rootMeanSquare(difference),
    greatest: difference.reduce((most, value) => Math.max(most, Math.abs(value)), 0),
    of: rootMeanSquare(a),
  };
}

export const comparedTable = ({ time, a, b, difference }: Compared): NumberTable => ({
  name: 'compared',
  columns: [
    { name: 'time (s)', values: time },
    { name: 'displacement A (m)', values: a },
    { name: 'displacement B (m)', values: b },
    { name: 'B less A (m)', values: difference },
  ],
});
