/** A number that the reader sets by dragging in the stage alone: it has no row. */
export interface DraggedNumber {
  readonly id: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly value: number;
}

/** A number that the reader sets with a slider or by typing. */
export interface NumberControl extends DraggedNumber {
  readonly label: string;
  readonly unit?: string;
}

/** One of a few words. */
export interface ChoiceControl {
  readonly id: string;
  readonly label: string;
  readonly options: readonly { readonly value: string; readonly label: string }[];
  readonly value: string;
}

/** Yes or no. */
export interface SwitchControl {
  readonly id: string;
  readonly label: string;
  readonly value: boolean;
}

export type Control = NumberControl | ChoiceControl | SwitchControl;
/** What a figure keeps, has in its address, and puts back. */
export type Kept = Control | DraggedNumber;
export type Value = number | string | boolean;
export type Values = Readonly<Record<string, Value>>;

export const isNumber = <Number extends DraggedNumber>(
  control: Number | ChoiceControl | SwitchControl,
): control is Number => 'min' in control;
export const isChoice = (control: Kept): control is ChoiceControl => 'options' in control;

/** The value of a number control. Throws where `id` is none. */
export function numberOf(values: Values, id: string): number {
  const value = values[id];
  if (typeof value !== 'number') throw new Error(`'${id}' is no number of this figure.`);
  return value;
}

/** The value of a choice. Throws where `id` is none. */
export function choiceOf(values: Values, id: string): string {
  const value = values[id];
  if (typeof value !== 'string') throw new Error(`'${id}' is no choice of this figure.`);
  return value;
}

/** The value of a switch. Throws where `id` is none. */
export function switchOf(values: Values, id: string): boolean {
  const value = values[id];
  if (typeof value !== 'boolean') throw new Error(`'${id}' is no switch of this figure.`);
  return value;
}

/** What a figure begins with. */
export const defaultsOf = (controls: readonly Kept[]): Record<string, Value> =>
  Object.fromEntries(controls.map(({ id, value }) => [id, value]));

/** Digits behind the point that a step asks for. */
export const digitsOf = (step: number): number => Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9)));

/** A value as its control allows it: a number in its range and on its steps; undefined where it makes no sense there. */
export function allowed(control: Kept, value: Value): Value | undefined {
  if (isNumber(control)) {
    const number = Number(value);
    if (value === '' || !Number.isFinite(number)) return undefined;
    const { min, max, step } = control;
    const stepped = min + Math.round((Math.min(max, Math.max(min, number)) - min) / step) * step;
    return Number(Math.min(max, stepped).toFixed(digitsOf(step) + 2));
  }
  if (isChoice(control)) return control.options.some((option) => option.value === value) ? value : undefined;
  return typeof value === 'boolean' ? value : undefined;
}
