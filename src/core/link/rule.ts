/** What a number of a document may be: its unit, its range, and the digits that a link keeps of it. */
export interface NumberRule {
  /** Name to show, lower case. */
  readonly label: string;
  /** Symbol of the unit, empty for a bare number. */
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  /** Digits after the point, in the link and so in the document. */
  readonly decimals: number;
  /** `max` is the same as `min`: a turn. */
  readonly wraps?: true;
}

/** A rule of a number that a slider offers. */
export interface SliderRule extends NumberRule {
  /** What a slider reaches and the step of its arrow keys; typing reaches `max`. */
  readonly slider: { readonly min: number; readonly max: number; readonly step: number };
  /** One sentence. */
  readonly help: string;
}

/** `value` with the digits that a link keeps, inside the range; never -0. What is no number is the least. */
export function roundTo(rule: NumberRule, value: number): number {
  const inside = Number.isNaN(value) ? rule.min : Math.min(rule.max, Math.max(rule.min, value));
  return Number(inside.toFixed(rule.decimals)) + 0;
}

/** `value` with the digits that a link keeps, in [0, max) of a rule that wraps. */
export function wrap(rule: NumberRule, value: number): number {
  return roundTo(rule, ((value % rule.max) + rule.max) % rule.max) % rule.max;
}

/** What people read of `value`, as the rule keeps it. */
export const kept = (rule: NumberRule, value: number): number =>
  rule.wraps ? wrap(rule, value) : roundTo(rule, value);

/** The number that `text` is by the rule, or undefined: plain decimal digits alone, within the range. */
export function readNumber(rule: NumberRule, text: string): number | undefined {
  const pattern = rule.decimals === 0 ? /^-?\d{1,15}$/ : /^-?\d{1,15}(\.\d{1,15})?$/;
  if (!pattern.test(text)) return undefined;
  const value = Number(text);
  return value < rule.min || value > rule.max ? undefined : roundTo(rule, value);
}

/** What the rule allows, in words: `a number from 0 to 10 m`. */
export function allowed(rule: NumberRule): string {
  const unit = rule.unit && rule.unit !== 'k' ? ` ${rule.unit}` : '';
  return `a ${rule.decimals === 0 ? 'whole number' : 'number'} from ${rule.min} to ${rule.max}${unit}`;
}
