/** Words that loggers write where they have no value. */
const MISSING = /^(|-+|nan|na|n\/a|null|none|nil|\?+)$/i;

/** Numbers that loggers write where they have no speed or direction. */
const NO_VALUE = /^[+-]?9999?([.,]0*)?$/;

/** A number with a point, or a comma where `comma` says that it is none of the separators. */
const NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i;

/** The number that a cell is; null where it says that there is none; undefined where it is something else. */
export function numberOf(cell: string): number | null | undefined {
  const text = cell.trim();
  if (MISSING.test(text)) return null;
  return NUMBER.test(text) ? Number(text.replace(',', '.')) : undefined;
}

/** The speed or direction that a cell is, as `numberOf`; 999 and 9999 say that there is none. */
export const measuredOf = (cell: string): number | null | undefined =>
  NO_VALUE.test(cell.trim()) ? null : numberOf(cell);

/** Year, month, day, hour, minute, second, fraction, and the zone: ISO 8601, with T or a space, seconds and zone optional. */
const STAMP = /^(\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d)(?::(\d\d)(?:[.,](\d{1,9}))?)?\s*(Z|[+-]\d\d(?::?\d\d)?)?$/i;

/** Days since the first of March of the year 0 in the Gregorian calendar; the leap day is then the last of its year. */
function dayNumber(year: number, month: number, day: number): number {
  const y = month <= 2 ? year - 1 : year;
  const m = month <= 2 ? month + 9 : month - 3;
  return (
    365 * y + Math.floor(y / 4) - Math.floor(y / 100) + Math.floor(y / 400) + Math.floor((153 * m + 2) / 5) + day - 1
  );
}

/** Seconds to take off a time to have that of the zone 0; a stamp without a zone is taken as it stands. */
function zoneSeconds(zone: string | undefined): number {
  if (!zone || /^z$/i.test(zone)) return 0;
  const digits = zone.slice(1).replace(':', '');
  const seconds = 3600 * Number(digits.slice(0, 2)) + 60 * Number(digits.slice(2) || 0);
  return zone.startsWith('-') ? -seconds : seconds;
}

/** Seconds since a day long past of an ISO 8601 time stamp; undefined where the cell is none. The same in every time zone. */
export function stampSeconds(cell: string): number | undefined {
  const found = STAMP.exec(cell.trim());
  if (!found) return undefined;
  const [year, month, day, hour, minute] = found.slice(1, 6).map(Number) as [number, number, number, number, number];
  const second = Number(found[6] ?? 0);
  if (month < 1 || month > 12 || day < 1 || day > 31 || hour > 24 || minute > 59 || second > 60) return undefined;
  // Whole seconds first: a fraction behind eleven digits would lose its last ones.
  const whole = 86_400 * dayNumber(year, month, day) + 3600 * hour + 60 * minute + second - zoneSeconds(found[8]);
  return whole - EPOCH + Number(`0.${found[7] ?? 0}`);
}

/** The first of January 2000, so that seconds of our days keep their fractions to a millionth. */
const EPOCH = 86_400 * dayNumber(2000, 1, 1);
