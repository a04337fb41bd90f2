import type { Parameter } from '../file/parameter.ts';
import type { ParameterValue } from './edits.ts';

/** Digits after the point of a number as people write it. */
const digits = (x: number): number => /\.(\d+)$/.exec(String(x))?.[1]?.length ?? 0;

/** Digits that are kept beyond those of the step: a typed value may be finer than a slider's, a sum of steps leaves none. */
const FINER = 2;

/**
 * An allowed value as documents and links keep it: two digits finer than the parameter's step, colours in small letters.
 *
 * So 0.1 + 0.2 is 0.3. Rounding again changes nothing, and what is allowed stays allowed.
 */
export function roundValue(parameter: Parameter, value: ParameterValue): ParameterValue {
  if (typeof value === 'string') return parameter.kind === 'colour' ? value.toLowerCase() : value;
  if (parameter.kind !== 'number' && parameter.kind !== 'numbers') return value;
  const { min, max, step } = parameter;
  const kept = Math.max(digits(step) + FINER, digits(min), digits(max));
  // No -0: it is not what a link gives back.
  const round = (x: number): number => Number(x.toFixed(kept)) + 0;
  return typeof value === 'number' ? round(value) : Array.isArray(value) ? value.map(round) : value;
}
