import type { NumberRule } from '../core/link/rule.ts';

/** How the text of an attribute is read and written; `allowed` is what it may be, in words. */
export interface AttributeRule<T> {
  /** The value, or undefined where the text is none. */
  read(text: string): T | undefined;
  write(value: T): string;
  readonly allowed: string;
}

/** A number and, right behind it, letters of a unit: '6m/s', '0.5 turn', '-3'. */
const AMOUNT = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?)\s*([a-z°][a-z/]*)?\s*$/i;

/** `value` without the tail that binary fractions leave. */
const plain = (value: number): string => String(Number(value.toPrecision(9)));

/** Factors to the base unit; the first unit is the one that is written. */
type Units = Readonly<Record<string, number>>;

function amount(text: string, units: Units, bare: boolean): number | undefined {
  const [, digits, unit] = AMOUNT.exec(text) ?? [];
  if (digits === undefined) return undefined;
  const value = Number(digits);
  const name = unit?.toLowerCase();
  const factor = name === undefined ? (bare || value === 0 ? 1 : undefined) : units[name];
  return factor === undefined || !Number.isFinite(value * factor) ? undefined : value * factor;
}

const within = (value: number | undefined, min: number, max: number): number | undefined =>
  value !== undefined && value >= min && value <= max ? value : undefined;

const SPEEDS: Units = { 'm/s': 1, 'km/h': 1 / 3.6 };
const ANGLES: Units = { deg: 1, '°': 1, rad: 180 / Math.PI, turn: 360, turns: 360 };
const TIMES: Units = { s: 1, ms: 1e-3, min: 60 };
const LENGTHS: Units = { m: 1, cm: 0.01 };

/** Fastest wind that can be asked for, metres a second: more than any hurricane. */
const FASTEST = 60;

/** Metres a second: '6m/s', '20km/h'. */
export const SPEED: AttributeRule<number> = {
  read: (text) => within(amount(text, SPEEDS, false), 0, FASTEST),
  write: (value) => `${plain(value)}m/s`,
  allowed: `a speed from 0 to ${FASTEST} m/s with its unit: "6m/s" or "20km/h"`,
};

/** Degrees: '240deg', '1rad', '0.5turn'. */
export const ANGLE: AttributeRule<number> = {
  read: (text) => within(amount(text, ANGLES, false), -3600, 3600),
  write: (value) => `${plain(value)}deg`,
  allowed: 'an angle with its unit: "240deg", "4.2rad" or "0.5turn"',
};

/** Seconds: '3s', '500ms', '2min', or a bare number. */
export const SECONDS: AttributeRule<number> = {
  read: (text) => within(amount(text, TIMES, true), 0, 1_000_000),
  write: (value) => `${plain(value)}s`,
  allowed: 'a time from 0 to 1000000 s: "3s", "500ms" or "2min"',
};

/** A bare number by a rule of the links. */
export const numberBy = ({ min, max, decimals }: NumberRule): AttributeRule<number> => ({
  read: (text) => {
    const value = within(amount(text, {}, true), min, max);
    return value === undefined || (decimals === 0 && !Number.isInteger(value)) ? undefined : value;
  },
  write: String,
  allowed: `a ${decimals === 0 ? 'whole number' : 'number'} from ${min} to ${max}`,
});

/** One of some words. */
export const oneOf = <T extends string>(words: readonly T[]): AttributeRule<T> => ({
  read: (text) => words.find((word) => word === text.trim().toLowerCase()),
  write: (value) => value,
  allowed: words.map((word) => `"${word}"`).join(', '),
});

/** 'on' or 'off': for what is on by default, which an attribute that is only there or not cannot say. */
export const SWITCH: AttributeRule<boolean> = {
  read: (text) => ({ '': true, on: true, true: true, off: false, false: false })[text.trim().toLowerCase()],
  write: (value) => (value ? 'on' : 'off'),
  allowed: '"on" or "off"',
};

/** Any text. */
export const TEXT: AttributeRule<string> = { read: (text) => text, write: (value) => value, allowed: 'a text' };

/** Where a camera stands about the tree; null: as the tree's frame has it. */
export interface CameraOrbit {
  /** Degrees about the vertical, 0 from +z. */
  readonly azimuth: number | null;
  /** Degrees from straight above, 0 to 180: 90 is level. */
  readonly polar: number | null;
  /** Metres from what it looks at, > 0. */
  readonly distance: number | null;
}

/** Three parts: angle about the tree, angle from straight above, distance; each may be 'auto'. */
export const ORBIT: AttributeRule<CameraOrbit> = {
  read(text) {
    const parts = text.trim().split(/\s+/);
    if (parts.length !== 3) return undefined;
    const [azimuth, polar, distance] = [
      orAuto(parts[0]!, (part) => ANGLE.read(part)),
      orAuto(parts[1]!, (part) => within(ANGLE.read(part), 0, 180)),
      orAuto(parts[2]!, (part) => within(amount(part, LENGTHS, false), 0.01, 10_000)),
    ];
    if (azimuth === undefined || polar === undefined || distance === undefined) return undefined;
    return { azimuth, polar, distance };
  },
  write: ({ azimuth, polar, distance }) =>
    [
      azimuth === null ? 'auto' : ANGLE.write(azimuth),
      polar === null ? 'auto' : ANGLE.write(polar),
      distance === null ? 'auto' : `${plain(distance)}m`,
    ].join(' '),
  allowed:
    'an angle about the tree, an angle from straight above and a distance, each may be "auto": "30deg 75deg 12m"',
};

const orAuto = (part: string, read: (part: string) => number | undefined): number | null | undefined =>
  part.toLowerCase() === 'auto' ? null : read(part);
