import { oneLine } from './one-line.ts';
import type { NumberParameter, NumbersParameter, Parameter } from './parameter.ts';

const UNITS: Readonly<Record<string, string>> = {
  m: 'metres',
  s: 'seconds',
  'm/s': 'metres a second',
  deg: 'degrees',
  Hz: 'hertz',
  turns: 'turns',
  GPa: 'gigapascals',
  'kg/m³': 'kilograms a cubic metre',
  'kg/m²': 'kilograms a square metre',
};

const range = (p: NumberParameter | NumbersParameter): string =>
  `from ${p.min} to ${p.max}${UNITS[p.unit] ? ` ${UNITS[p.unit]}` : ''}`;

/** What a parameter may be, in words: 'a whole number from 1 to 200'. */
export function allowedValues(p: Parameter): string {
  switch (p.kind) {
    case 'number':
      return `a ${p.integer ? 'whole ' : ''}number ${range(p)}${p.orNull ? ', or null' : ''}`;
    case 'numbers':
      return `a list of ${p.least ?? 1} to 8 numbers ${range(p)}`;
    case 'flag':
      return 'true or false';
    case 'choice':
      return p.choices.map((choice) => `"${choice}"`).join(', ');
    case 'colour':
      return 'a colour as "#rrggbb"';
  }
}

const inRange = (p: NumberParameter | NumbersParameter, value: unknown): boolean =>
  typeof value === 'number' && value >= p.min && value <= p.max;

/** Whether a value is one that the parameter may have. */
export function isAllowed(p: Parameter, value: unknown): boolean {
  switch (p.kind) {
    case 'number':
      return (inRange(p, value) && (!p.integer || Number.isInteger(value))) || (value === null && !!p.orNull);
    case 'numbers':
      return (
        Array.isArray(value) && value.length >= (p.least ?? 1) && value.length <= 8 && value.every((v) => inRange(p, v))
      );
    case 'flag':
      return typeof value === 'boolean';
    case 'choice':
      return p.choices.some((choice) => choice === value);
    case 'colour':
      return typeof value === 'string' && /^#[0-9a-f]{6}$/i.test(value);
  }
}

/** A value as a message shows it: short, and never as markup. */
export function foundText(value: unknown): string {
  if (value === undefined) return 'nothing';
  if (value === null) return 'null';
  if (typeof value === 'string') return `the text "${oneLine(value)}"`;
  if (Array.isArray(value)) {
    const short = value.every((v) => typeof v === 'number') && value.length <= 8;
    return short ? `the list [${value.join(', ')}]` : `a list of ${value.length}`;
  }
  return typeof value === 'object' ? 'an object' : String(value);
}
