import Papa from 'papaparse';
import { foundText } from '../file/allowed.ts';
import type { Fault } from '../file/fault.ts';
import { measuredOf, numberOf, stampSeconds } from './anemometer-cells.ts';
import { type Columns, findColumns } from './anemometer-columns.ts';
import { resample, type Sample, stepsIn, usualStep } from './anemometer-resample.ts';
import { MOST_SAMPLES, RECORD_LIMITS } from './record-file.ts';
import type { WindRecord } from './wind.ts';

export type ParsedRecord =
  | {
      readonly record: WindRecord;
      /** What was filled in or taken for granted, in whole sentences with their lines. */
      readonly notes: readonly string[];
      readonly faults?: undefined;
    }
  | { readonly record?: undefined; readonly notes?: undefined; readonly faults: readonly Fault[] };

export interface AnemometerOptions {
  /** Name of the record to show, as that of its file. */
  readonly name: string;
  /** Where the wind blows to where the file does not say: radians from x to y; 0. */
  readonly direction?: number;
}

/** Longest CSV that is read: 36 000 lines have about 1 MB. */
const LONGEST_CSV = 16_000_000;

/** Most faults that are listed, and most notes of one kind: what is wrong once is often wrong in every line. */
const MOST_FAULTS = 40;
const MOST_NOTES = 12;

/** A gap that is filled is at most this long, in seconds or in steps; a longer one would be an invention. */
const LONGEST_GAP = { seconds: 10, steps: 10 } as const;

/**
 * Where a wind blows to that comes from `degrees`, as meteorologists say it: clockwise from north. Radians from x to y in tree space,
 * where x is east and y is north.
 */
export const blowsTo = (degrees: number): number => ((270 - degrees) * Math.PI) / 180;

/** The other way: degrees clockwise from north, 0..360, of the side that a wind comes from that blows towards `radians`. */
export function comesFrom(radians: number): number {
  const turns = 0.75 - radians / (2 * Math.PI);
  return 360 * (turns - Math.floor(turns));
}

/**
 * The record of an anemometer from its CSV file, or every fault with the number of its line. The header names the columns: a time (seconds,
 * or ISO 8601 time stamps), a speed (m/s, or km/h, knots or mph where the header says so) and, where there is one, the direction that the
 * wind comes from in degrees clockwise from north. Separated by commas, semicolons or tabs; decimals with a point or a comma.
 *
 * Short gaps, missing values and uneven steps are filled in between their neighbours and told in `notes`. At most 36 000 samples. Never
 * throws.
 */
export function parseAnemometer(text: string, { name, direction = 0 }: AnemometerOptions): ParsedRecord {
  const whole = (found: string, allowed: string): ParsedRecord => ({ faults: [{ path: '', found, allowed }] });
  const kind = "an anemometer's record as CSV: a header, then a line a sample";
  if (text.trim() === '') return whole('an empty file', kind);
  if (text.length > LONGEST_CSV) return whole(`${text.length} characters`, `at most ${LONGEST_CSV}`);
  const faults: Fault[] = [];
  const [header, ...lines] = linesOf(text.replace(/^\ufeff/, ''));
  if (!header) return whole('nothing but empty lines and remarks', kind);
  const columns = findColumns(header.cells, header.line, faults);
  if (!columns) return { faults };
  const notes: string[] = [];
  const reader = new SampleReader(columns, header.cells.length, direction, faults);
  for (const { line, cells } of lines) {
    if (faults.length >= MOST_FAULTS) break;
    reader.read(line, cells);
  }
  if (faults.length > 0) return { faults };
  const { samples, missing, times } = reader;
  if (samples.length < 2) return whole(`${samples.length} samples`, 'at least 2');
  if (!columns.speed.said) notes.push('The header gives no unit of the speed: taken as metres a second.');
  if (!columns.direction) notes.push('There is no column of directions: all of it blows the same way.');
  notes.push(...told(missing.map((line) => `Line ${line} has no value: filled in between its neighbours.`)));
  return assemble(name, samples, times, notes);
}

interface Line {
  /** Number of its line, from 1. */
  readonly line: number;
  readonly cells: readonly string[];
}

/** The lines that say something: neither empty nor a remark behind #. */
function linesOf(text: string): Line[] {
  // Papa Parse takes \r\n for the end only where the first line has it.
  const input = text.replace(/\r\n?/g, '\n');
  const { data } = Papa.parse<string[]>(input, { delimiter: separatorOf(input) });
  let line = 1;
  return data.flatMap((cells) => {
    const here = { line, cells };
    // A cell in quotes may hold line breaks.
    line += 1 + cells.reduce((sum, cell) => sum + cell.split('\n').length - 1, 0);
    const empty = cells.every((cell) => cell.trim() === '');
    return empty || cells[0].trimStart().startsWith('#') ? [] : [here];
  });
}

/** The separator that the header uses. The numbers would mislead: their commas may be decimal ones. */
function separatorOf(text: string): string {
  const header = /^(?!\s*(?:#|$)).*$/m.exec(text)?.[0] ?? '';
  return ['\t', ';'].find((separator) => header.includes(separator)) ?? ',';
}

/** Reads line after line into samples; faults go on its list, lines without a value on that of the missing. */
class SampleReader {
  readonly samples: Sample[] = [];
  readonly missing: number[] = [];
  /** Times of all lines, by their numbers; a logger keeps its step also where it has no value. */
  readonly times = new Map<number, number>();
  readonly #columns: Columns;
  readonly #width: number;
  readonly #faults: Fault[];
  #direction: number;
  /** Whether times are stamps; the first line decides. */
  #stamps: boolean | undefined;
  #last = Number.NEGATIVE_INFINITY;

  constructor(columns: Columns, width: number, direction: number, faults: Fault[]) {
    this.#columns = columns;
    this.#width = width;
    this.#direction = direction;
    this.#faults = faults;
  }

  read(line: number, cells: readonly string[]): void {
    if (cells.length > this.#width) {
      const allowed = `${this.#width}, as the header has; numbers with decimal commas need semicolons or tabs between them`;
      this.#faults.push({ path: `line ${line}`, found: `${cells.length} values`, allowed });
      return;
    }
    const time = this.#time(line, cells);
    if (time === undefined) return;
    const speed = this.#number(line, cells, 'speed');
    const from = this.#number(line, cells, 'direction');
    if (speed === undefined || from === undefined) return;
    // A vane that stands still in a calm has no direction: it is where it was.
    if (from !== null) this.#direction = blowsTo(from);
    if (speed === null || (from === null && this.#columns.direction && speed > 0)) this.missing.push(line);
    if (speed !== null) this.samples.push({ line, time, speed, direction: this.#direction });
  }

  /** The time of a line in seconds; undefined, and a fault, where it has none. */
  #time(line: number, cells: readonly string[]): number | undefined {
    const { index, factor } = this.#columns.time;
    const cell = cells[index] ?? '';
    const stamp = stampSeconds(cell);
    const seconds = stamp ?? numberOf(cell);
    const path = `line ${line}, time`;
    this.#stamps ??= stamp !== undefined;
    if (typeof seconds !== 'number' || this.#stamps !== (stamp !== undefined)) {
      const allowed = this.#stamps ? 'a time stamp as 2024-05-31T12:00:00.2' : 'a number of seconds, as 12.5';
      this.#faults.push({ path, found: foundText(cell), allowed });
      return undefined;
    }
    const time = stamp ?? seconds * factor;
    if (!(time > this.#last)) {
      this.#faults.push({ path, found: foundText(cell), allowed: 'a time after that of the line before' });
      return undefined;
    }
    this.#last = time;
    this.times.set(line, time);
    return time;
  }

  /** A speed in metres a second or a direction in degrees; null where there is none; undefined, and a fault, where it is wrong. */
  #number(line: number, cells: readonly string[], key: 'speed' | 'direction'): number | null | undefined {
    const column = this.#columns[key];
    if (!column) return null;
    const cell = cells[column.index] ?? '';
    const value = measuredOf(cell);
    if (value === null) return null;
    const { min, max } = RECORD_LIMITS[key];
    const inUnits = value === undefined ? Number.NaN : value * column.factor;
    if (inUnits >= min && inUnits <= max) return inUnits;
    const range = `from ${min} to ${Math.round(max / column.factor)}`;
    const allowed = `a number ${range}${key === 'direction' ? ' degrees' : ''}, or nothing`;
    this.#faults.push({ path: `line ${line}, ${key}`, found: foundText(cell), allowed });
    return undefined;
  }
}

/** The record of samples at whatever times; `lines` are the times of all lines by their numbers. */
function assemble(
  name: string,
  samples: readonly Sample[],
  lines: ReadonlyMap<number, number>,
  notes: string[],
): ParsedRecord {
  const times = [...lines];
  const step = usualStep(times.map(([, time]) => time));
  const { min, max } = RECORD_LIMITS.step;
  const fault = (path: string, found: string, allowed: string): Fault => ({ path, found, allowed });
  if (!(step >= min && step <= max))
    return { faults: [fault('time', `a step of ${step} seconds`, `a step from ${min} to ${max} seconds`)] };
  const count = stepsIn(samples, step);
  if (count > MOST_SAMPLES) {
    const allowed = `at most ${MOST_SAMPLES}: a shorter part, or averages over a longer step`;
    return { faults: [fault('', `${count} samples`, allowed)] };
  }
  const longest = Math.max(LONGEST_GAP.seconds, LONGEST_GAP.steps * step);
  const allowed = `at most ${round(longest)} seconds from sample to sample`;
  const faults = samples.slice(1).flatMap(({ line, time }, i) => {
    const gap = time - samples[i].time;
    return gap > longest * (1 + 1e-9) ? [fault(`line ${line}, time`, `a gap of ${round(gap)} seconds`, allowed)] : [];
  });
  if (faults.length > 0) return { faults: faults.slice(0, MOST_FAULTS) };
  const steps = times.slice(1).map(([line, time], i) => ({ line, gap: time - times[i][1] }));
  const gaps = steps.filter(({ gap }) => gap > 1.5 * step);
  notes.push(
    ...told(gaps.map(({ line, gap }) => `Before line ${line} ${round(gap)} seconds have no sample: filled in.`)),
  );
  if (steps.some(({ gap }) => gap <= 1.5 * step && Math.abs(gap / step - 1) > 0.02))
    notes.push(`Its steps are uneven: resampled to one of ${step} seconds.`);
  return { record: { name: name.slice(0, 80), step, ...resample(samples, step) }, notes };
}

const round = (seconds: number): number => Number(seconds.toPrecision(3));

/** The first of many notes, and how many more there are. */
const told = (notes: readonly string[]): string[] =>
  notes.length <= MOST_NOTES
    ? [...notes]
    : [...notes.slice(0, MOST_NOTES), `${notes.length - MOST_NOTES} more lines like these.`];
