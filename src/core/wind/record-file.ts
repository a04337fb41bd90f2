import { foundText } from '../file/allowed.ts';
import type { Fault } from '../file/fault.ts';
import { fieldsOf, listOf, unknownKeys } from '../file/read.ts';
import type { WindRecord } from './wind.ts';

/** Most samples of a record: an hour at ten a second. */
export const MOST_SAMPLES = 36_000;

/** What the numbers of a record may be: seconds, metres a second, and degrees in files. */
export const RECORD_LIMITS = {
  step: { min: 0.01, max: 600, unit: ' seconds' },
  speed: { min: 0, max: 100, unit: ' metres a second' },
  direction: { min: -360, max: 360, unit: ' degrees' },
} as const;

/** The longest name of a record. */
const LONGEST_NAME = 80;

/** A file beside the wind file, not one elsewhere. */
const CSV_NAME = /^[\w-][\w.-]{0,75}\.csv$/i;

type Limits = (typeof RECORD_LIMITS)[keyof typeof RECORD_LIMITS];

const inside = (value: unknown, { min, max }: Limits): value is number =>
  typeof value === 'number' && value >= min && value <= max;

const range = ({ min, max, unit }: Limits): string => `from ${min} to ${max}${unit}`;

/**
 * The record of a wind file: null, the samples themselves, or the name of a CSV file beside it. Directions are degrees in the file,
 * towards which it blows, from x to y as those of waves.
 */
export function readRecord(
  value: unknown,
  faults: Fault[],
): { readonly record: WindRecord | null; readonly recordFile: string | null } {
  if (value === undefined || value === null) return { record: null, recordFile: null };
  if (typeof value === 'string') {
    if (!CSV_NAME.test(value)) {
      const allowed = 'the name of a CSV file beside this one, as "measured.csv"';
      faults.push({ path: 'record', found: foundText(value), allowed });
    }
    return { record: null, recordFile: value };
  }
  return { record: readSamples(value, faults), recordFile: null };
}

function readSamples(value: unknown, faults: Fault[]): WindRecord | null {
  if (typeof value !== 'object' || Array.isArray(value)) {
    const allowed = 'null, the name of a CSV file, or an object with name, step, speed and direction';
    faults.push({ path: 'record', found: foundText(value), allowed });
    return null;
  }
  const fields = fieldsOf(value, 'record', faults) ?? {};
  unknownKeys(fields, 'record.', ['name', 'step', 'speed', 'direction'], faults);
  const { name, step } = fields;
  if (typeof name !== 'string' || name.length > LONGEST_NAME)
    faults.push({ path: 'record.name', found: foundText(name), allowed: `a text of up to ${LONGEST_NAME} characters` });
  if (!inside(step, RECORD_LIMITS.step))
    faults.push({ path: 'record.step', found: foundText(step), allowed: `a number ${range(RECORD_LIMITS.step)}` });
  const speed = numbersAt(fields.speed, 'speed', faults);
  const direction = numbersAt(fields.direction, 'direction', faults);
  if (speed && direction && speed.length !== direction.length)
    faults.push({
      path: 'record.direction',
      found: `a list of ${direction.length}`,
      allowed: `a list of ${speed.length} numbers, as many as record.speed`,
    });
  if (!speed || !direction || typeof name !== 'string' || typeof step !== 'number') return null;
  return { name, step, speed, direction: direction.map((degrees) => (degrees * Math.PI) / 180) };
}

/** A list of samples; of many that are wrong the first is enough to find the others. */
function numbersAt(value: unknown, key: 'speed' | 'direction', faults: Fault[]): number[] | undefined {
  const limits = RECORD_LIMITS[key];
  const allowed = `a list of 2 to ${MOST_SAMPLES} numbers ${range(limits)}`;
  const list = listOf(value, [2, MOST_SAMPLES], `record.${key}`, allowed, faults);
  if (!list) return undefined;
  const wrong = list.findIndex((entry) => !inside(entry, limits));
  if (wrong < 0) return list as number[];
  faults.push({ path: `record.${key}[${wrong}]`, found: foundText(list[wrong]), allowed: `a number ${range(limits)}` });
  return undefined;
}
