import { foundText } from '../file/allowed.ts';
import { type Fault, readJson } from '../file/fault.ts';
import type { Parameter } from '../file/parameter.ts';
import {
  type Absent,
  type Fields,
  fieldsOf,
  hasFormat,
  listOf,
  readParameters,
  readTexts,
  unknownKeys,
} from '../file/read.ts';
import { readRecord } from './record-file.ts';
import { type Gust, gustRepeat, SHORTEST_REPEAT, type Wind } from './wind.ts';
import { WIND_PARTS, type WindPart } from './wind-parameters.ts';

export type ParsedWind =
  | {
      readonly wind: Wind;
      /** The CSV file beside this one that has the record: `loadWind` reads it; until then `wind.record` is null. */
      readonly recordFile: string | null;
      readonly faults?: undefined;
    }
  | { readonly wind?: undefined; readonly recordFile?: undefined; readonly faults: readonly Fault[] };

/** A wind file is a few kilobytes, with a record in it a few hundred; this much is something else. */
export const LONGEST_WIND = 4_000_000;

/** The texts at the head of a wind file. */
export const WIND_TEXTS = { name: { longest: 80, required: true }, description: { longest: 200 } } as const;

/** What a wind file leaves out is as in a still wind with all settings at their defaults. */
const ABSENT: Absent = { isRequired: () => false, defaultOf: (p) => p.default };

/**
 * A wind from the text of a file, or from what JSON.parse made of it; every fault where there are any, each with its path.
 *
 * Angles are degrees in the file and radians in the wind. Whatever is left out has its default, but for format, version and name.
 * Never throws.
 */
export function parseWind(file: unknown): ParsedWind {
  if (typeof file !== 'string') return readWind(file);
  const { value, fault } = readJson(file, 'a wind', LONGEST_WIND);
  return fault ? { faults: [fault] } : readWind(value);
}

function readWind(value: unknown): ParsedWind {
  const faults: Fault[] = [];
  const file = fieldsOf(value, '', faults);
  if (!file || !hasFormat(file, 'windgrove-wind', faults)) return { faults };
  const { whole, waves, gusts, profile, spring, springLevels, sway } = WIND_PARTS;
  const known = ['format', 'version', '$schema', ...Object.keys(WIND_TEXTS), ...keysOf(whole)];
  unknownKeys(file, '', [...known, 'waves', 'gusts', 'profile', 'spring', 'sway', 'record'], faults);
  const springFields = partAt(spring, file.spring, faults, ['levels']);
  const { record, recordFile } = readRecord(file.record, faults);
  const wind: Readonly<Record<keyof Wind, unknown>> = {
    ...(readTexts(file, WIND_TEXTS, faults) as Pick<Wind, 'name' | 'description'>),
    ...(valuesOf(whole, file, '', faults) as Omit<Wind, 'name'>),
    waves: listAt(waves, file.waves, faults),
    gusts: listAt(gusts, file.gusts, faults),
    profile: partAt(profile, file.profile, faults).values,
    spring: { ...springFields.values, levels: listAt(springLevels, springFields.fields.levels, faults) },
    sway: partAt(sway, file.sway, faults).values,
    record,
  };
  checkProfile((wind as unknown as Wind).profile, faults);
  checkRepeats((wind as unknown as Wind).gusts, faults);
  return faults.length > 0 ? { faults } : { wind: wind as unknown as Wind, recordFile };
}

const keysOf = (part: WindPart): string[] => part.parameters.map((p) => p.key);

/** Radians of degrees; 15 degrees are the same number wherever they were written. */
export const radiansOf = (degrees: number): number => (degrees * Math.PI) / 180;

/** Whether the values of a parameter are degrees in the file and radians in the wind. */
export const isAngle = (p: Parameter): boolean => p.kind === 'number' && p.unit === 'deg';

/** The values of a part, in the units of the wind. */
function valuesOf(part: WindPart, fields: Fields, prefix: string, faults: Fault[]): Record<string, unknown> {
  const values = readParameters(part.parameters, fields, prefix, ABSENT, faults);
  for (const p of part.parameters) {
    const degrees = values[p.key];
    if (isAngle(p) && typeof degrees === 'number') values[p.key] = radiansOf(degrees);
  }
  return values;
}

/** A part that is one object: its values, and the fields that stand there; `more` are keys that it has besides its parameters. */
function partAt(
  part: WindPart,
  value: unknown,
  faults: Fault[],
  more: readonly string[] = [],
  path: string = part.group,
) {
  const fields = value === undefined ? {} : (fieldsOf(value, path, faults) ?? {});
  unknownKeys(fields, `${path}.`, [...keysOf(part), ...more], faults);
  return { fields, values: valuesOf(part, fields, `${path}.`, faults) };
}

/** A part that is a list of objects; none where the file says nothing of it. */
function listAt(part: WindPart, value: unknown, faults: Fault[]): unknown[] {
  if (value === undefined) return [];
  const { group, title, most = 1 } = part;
  const what = group === 'spring.levels' ? 'levels' : title.toLowerCase();
  const entries = listOf(value, [0, most], group, `a list of up to ${most} ${what}`, faults) ?? [];
  return entries.map((entry, i) => partAt(part, entry, faults, [], `${group}[${i}]`).values);
}

/** A gust comes again when it is over, not before. */
function checkRepeats(gusts: readonly Gust[], faults: Fault[]): void {
  gusts.forEach((gust, i) => {
    const least = gustRepeat(gust);
    // A file has decimals, whose sum may be off in the last digit.
    if (!(least > gust.repeat + 1e-9)) return;
    faults.push({
      path: `gusts[${i}].repeat`,
      found: foundText(gust.repeat),
      allowed: `0, or at least ${Number(least.toFixed(6))} seconds: ${SHORTEST_REPEAT}, and its rise and fall`,
    });
  });
}

/** The logarithmic law has no wind at the roughness length, and none to measure by below it. */
function checkProfile({ kind, height, roughness }: Wind['profile'], faults: Fault[]): void {
  if (kind !== 'log' || !(roughness >= height)) return;
  faults.push({
    path: 'profile.roughness',
    found: foundText(roughness),
    allowed: `less than profile.height, ${height}`,
  });
}
