/** A factor on a value in metres (or metres a second), and the unit that it is then in. */
export interface LengthUnit {
  readonly factor: number;
  readonly unit: 'mm' | 'cm' | 'm';
  /** As a screen reader says it. */
  readonly spoken: string;
}

const MM: LengthUnit = { factor: 1000, unit: 'mm', spoken: 'millimetres' };
const CM: LengthUnit = { factor: 100, unit: 'cm', spoken: 'centimetres' };
const M: LengthUnit = { factor: 1, unit: 'm', spoken: 'metres' };

/** The unit in which values up to `most` metres read well. */
export const lengthUnit = (most: number): LengthUnit => (most < 0.02 ? MM : most < 1 ? CM : M);

/** `value` with about three digits, and never -0. */
export function threeDigits(value: number): string {
  const size = Math.abs(value);
  const decimals = size >= 100 ? 0 : size >= 10 ? 1 : 2;
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text.replace('-', '\u2212');
}

/** A length in metres in the unit that suits it: `3.20 cm`. */
export function lengthText(metres: number): string {
  const { factor, unit } = lengthUnit(Math.abs(metres));
  return `${threeDigits(metres * factor)}\u2009${unit}`;
}

/** A small length in metres, down to micrometres: `0.4 µm`. */
export function smallLengthText(metres: number): string {
  const size = Math.abs(metres);
  return size < 1e-4 ? `${(metres * 1e6).toFixed(size < 1e-5 ? 1 : 0)}\u2009µm` : lengthText(metres);
}

/** The step 1, 2 or 5 times a power of ten of which about `parts` make `size`; size > 0. */
export function niceStep(size: number, parts: number): number {
  const raw = size / parts;
  const power = 10 ** Math.floor(Math.log10(raw));
  const rest = raw / power;
  return power * (rest > 5 ? 10 : rest > 2 ? 5 : rest > 1 ? 2 : 1);
}

/**
 * The range of an axis that holds `low` to `high`, with ends on round numbers, so that it stays as it is while the values change a
 * little. At least `least` wide.
 */
export function niceRange(low: number, high: number, least: number): [low: number, high: number] {
  const middle = (low + high) / 2;
  const [a, b] =
    high - low >= least ? [low, high] : [Math.min(low, middle - least / 2), Math.max(high, middle + least / 2)];
  const step = niceStep(b - a, 4);
  return [Math.floor(a / step + 1e-9) * step, Math.ceil(b / step - 1e-9) * step];
}
