import type { Parameter } from '../file/parameter.ts';
import { isAngle, radiansOf } from './parse-wind.ts';
import type { Wind } from './wind.ts';
import { WIND_PARTS } from './wind-parameters.ts';

type Json = string | number | boolean | null | readonly Json[] | { readonly [key: string]: Json };
type JsonObject = { readonly [key: string]: Json };

/**
 * The fewest digits of degrees that are these radians again, bit for bit, or to 15 digits where no degrees are; within one turn.
 *
 * A direction that was typed as 15 degrees stands as 15 in the file, not as 14.999999999999998.
 */
export function degreesOf(radians: number): number {
  const degrees = (radians * 180) / Math.PI;
  if (Math.abs(degrees) > 360) return degreesOf(radians % (2 * Math.PI));
  for (let digits = 1; digits <= 16; digits++) {
    const short = Number(degrees.toPrecision(digits));
    if (radiansOf(short) === radians) return short;
  }
  return Number(degrees.toPrecision(15));
}

/** The values of a part's parameters as a file has them. */
function valuesOf(parameters: readonly Parameter[], of: object): JsonObject {
  const values = new Map<string, Json>(Object.entries(of));
  return Object.fromEntries(
    parameters.map((p) => {
      const value = values.get(p.key) ?? null;
      return [p.key, isAngle(p) && typeof value === 'number' ? degreesOf(value) : value];
    }),
  );
}

/**
 * The wind as its file: an object for JSON.stringify with everything written out, angles in degrees. `recordFile` is the name of a CSV
 * file beside it that has the record; without it the record's samples stand in the file. parseWind reads it back, to the last digit.
 */
export function windToFile(wind: Wind, recordFile: string | null = null): JsonObject {
  const { whole, waves, gusts, profile, spring, springLevels, sway } = WIND_PARTS;
  const { record } = wind;
  return {
    format: 'windgrove-wind',
    version: 1,
    name: wind.name,
    description: wind.description,
    ...valuesOf(whole.parameters, wind),
    waves: wind.waves.map((wave) => valuesOf(waves.parameters, wave)),
    gusts: wind.gusts.map((gust) => valuesOf(gusts.parameters, gust)),
    profile: valuesOf(profile.parameters, wind.profile),
    spring: {
      ...valuesOf(spring.parameters, wind.spring),
      levels: wind.spring.levels.map((level) => valuesOf(springLevels.parameters, level)),
    },
    sway: valuesOf(sway.parameters, wind.sway),
    record:
      recordFile ??
      (record && {
        name: record.name,
        step: record.step,
        speed: record.speed,
        direction: record.direction.map(degreesOf),
      }),
  };
}

/** The text of the wind's file: one line a value, but a wave, a gust or a list of numbers on one. */
export function windText(wind: Wind, recordFile: string | null = null): string {
  const text = JSON.stringify(windToFile(wind, recordFile), null, 2);
  // The innermost braces and brackets: what they hold is short, but for the samples of a record.
  const flat = text.replace(/(?<=^ {2,}(?:"(?:speed|direction)": )?)[{[]\n[^{}[\]]*[}\]](?=,?$)/gm, (part) =>
    part.replace(/\s*\n\s*/g, ' '),
  );
  return `${flat}\n`;
}
