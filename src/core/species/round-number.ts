import type { NumberParameter, NumbersParameter } from '../file/parameter.ts';

/** Digits after the point that a step has. */
const digitsOf = (step: number): number => String(step).split('.')[1]?.length ?? 0;

/** A number that the parameter may be: within its range, whole where it must be, else to a tenth of its step, as short as a link likes it. */
export function clampTo(parameter: NumberParameter | NumbersParameter, value: number): number {
  const inside = Math.min(parameter.max, Math.max(parameter.min, value));
  const whole =
    parameter.kind === 'number' && (parameter.integer === true || (parameter.step >= 1 && parameter.unit === ''));
  const rounded = whole ? Math.round(inside) : Number(inside.toFixed(digitsOf(parameter.step) + 1));
  return Math.min(parameter.max, Math.max(parameter.min, rounded)) + 0;
}
