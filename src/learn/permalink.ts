import { allowed, isChoice, isNumber, type Kept, type Value, type Values } from './controls.ts';

/** The part of an address behind `#` that shows a figure with these values: `fig=ID&a=1`; what is as it began is left out. */
export function writeFigure(figure: string, controls: readonly Kept[], values: Values): string {
  const pairs = controls
    .filter(({ id, value }) => values[id] !== undefined && values[id] !== value)
    .map(({ id }) => [id, String(values[id])]);
  return new URLSearchParams([['fig', figure], ...pairs]).toString();
}

/** The figure that an address names, or null. */
export const figureNamed = (hash: string): string | null => new URLSearchParams(hash.replace(/^#/, '')).get('fig');

/** The values in an address; those that it does not name, or that are not allowed, are left out. */
export function readFigure(hash: string, controls: readonly Kept[]): Record<string, Value> {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const values: Record<string, Value> = {};
  for (const control of controls) {
    const text = given.get(control.id);
    if (text === null) continue;
    const value = allowed(control, isNumber(control) || isChoice(control) ? text : text === 'true');
    if (value !== undefined) values[control.id] = value;
  }
  return values;
}
