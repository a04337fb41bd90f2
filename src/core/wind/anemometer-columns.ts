import type { Fault } from '../file/fault.ts';
import { oneLine } from '../file/one-line.ts';

/** A column of the file: where it stands, and the factor from its unit to seconds, metres a second or degrees. */
export interface Column {
  readonly index: number;
  readonly factor: number;
  /** Whether its header says the unit. */
  readonly said: boolean;
}

/** The columns of an anemometer's file; direction is optional. */
export interface Columns {
  readonly time: Column;
  readonly speed: Column;
  readonly direction: Column | null;
}

/** What a header may call a quantity, and its units with their factors; the first unit that fits holds. */
interface Quantity {
  readonly name: RegExp;
  readonly units: readonly (readonly [RegExp, number])[];
  readonly allowed: string;
}

const TIME: Quantity = {
  name: /^(time|timestamp|datetime|date|utc|sec|secs|seconds|elapsed)\b|^t( (s|ms|sec|min))?$/,
  units: [
    [/\b(ms|msec|milliseconds?)\b/, 0.001],
    [/\b(min|mins|minutes?)\b/, 60],
    [/\b(s|sec|secs|seconds?)\b/, 1],
  ],
  allowed: 'a column of times, headed as "time (s)", in seconds or as 2024-05-31T12:00:00.2',
};

const SPEED: Quantity = {
  name: /(speed|velocity|wind|\b(ws|v|u|ff)\b)/,
  units: [
    [/\b(km ?h|kmh|kph|km ?per ?hour)\b/, 1 / 3.6],
    [/\b(kn|kt|kts|knots?)\b/, 1852 / 3600],
    [/\b(mph|mi ?h)\b/, 0.44704],
    [/\b(m ?s( ?1)?|mps|m ?per ?s)\b/, 1],
  ],
  allowed: 'a column of speeds, headed as "speed (m/s)", "speed (km/h)" or "speed (knots)"',
};

const DIRECTION: Quantity = {
  name: /(dir|direction|bearing|azimuth|\b(wd|from|dd)\b)/,
  units: [[/./, 1]],
  allowed: '',
};

/** Columns of the same quantity that are not the wind from moment to moment. */
const OTHER = /\b(gusts?|max|maximum|min|minimum|std|sd|sigma|dev|err|error|vertical|w)\b/;

/** Lower case, with everything but letters and digits as single spaces: 'Wind speed [km/h]' is 'wind speed km h'. */
const words = (head: string): string =>
  head
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, ' ')
    .trim();

/** Which column of a header is which; a fault where one is not there. */
export function findColumns(header: readonly string[], line: number, faults: Fault[]): Columns | undefined {
  const heads = header.map(words);
  const find = ({ name, units }: Quantity, taken: readonly (number | undefined)[]): Column | null => {
    const fits = heads.flatMap((head, i) => (name.test(head) && !taken.includes(i) ? [i] : []));
    // Of several the first that is not a gust's or a maximum: loggers write those beside it.
    const index = fits.find((i) => !OTHER.test(heads[i])) ?? fits[0];
    if (index === undefined) return null;
    const factor = units.find(([unit]) => unit.test(heads[index]))?.[1];
    return { index, factor: factor ?? 1, said: factor !== undefined };
  };
  // 'wind direction' speaks of the wind too: what is surely a direction or a time is no speed.
  const direction = find(DIRECTION, []);
  const time = find(TIME, [direction?.index]);
  const speed = find(SPEED, [direction?.index, time?.index]);
  const missing = [time ? [] : [TIME], speed ? [] : [SPEED]].flat();
  for (const { allowed } of missing)
    faults.push({ path: `line ${line}`, found: `the header "${oneLine(header.join(', '), 60)}"`, allowed });
  return time && speed ? { time, speed, direction } : undefined;
}
