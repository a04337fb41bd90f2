import { foundText } from '../file/allowed.ts';
import type { Fault } from '../file/fault.ts';
import type { Fields } from '../file/read.ts';
import { allowed, kept, type NumberRule } from '../link/rule.ts';

/** Reads the values of one object of a file; what is absent has its default, and what is wrong is a fault and has it too. */
export class FieldReader {
  private readonly fields: Fields;
  private readonly prefix: string;
  private readonly faults: Fault[];

  /** `prefix` is '' or ends in a dot. */
  constructor(fields: Fields, prefix: string, faults: Fault[]) {
    this.fields = fields;
    this.prefix = prefix;
    this.faults = faults;
  }

  /** The value of a key; `undefined` where the file says nothing: never what every object has. */
  value(key: string): unknown {
    return Object.hasOwn(this.fields, key) ? this.fields[key] : undefined;
  }

  fault(key: string, allowedThere: string): void {
    this.faults.push({ path: `${this.prefix}${key}`, found: foundText(this.value(key)), allowed: allowedThere });
  }

  number(key: string, rule: NumberRule, fallback: number): number {
    const value = this.value(key);
    if (value === undefined) return fallback;
    const whole = rule.decimals > 0 || Number.isInteger(value);
    if (typeof value === 'number' && value >= rule.min && value <= rule.max && whole) return kept(rule, value);
    this.fault(key, allowed(rule));
    return fallback;
  }

  flag(key: string, fallback: boolean): boolean {
    const value = this.value(key);
    if (value === undefined || typeof value === 'boolean') return value ?? fallback;
    this.fault(key, 'true or false');
    return fallback;
  }

  choice<T extends string>(key: string, choices: readonly T[], fallback: T): T {
    const value = this.value(key);
    if (value === undefined) return fallback;
    const found = choices.find((choice) => choice === value);
    if (found === undefined) this.fault(key, choices.map((choice) => `"${choice}"`).join(', '));
    return found ?? fallback;
  }

  /** A text of 1 to `longest` letters. */
  text(key: string, longest: number, fallback: string): string {
    const value = this.value(key);
    if (value === undefined) return fallback;
    if (typeof value === 'string' && value !== '' && value.length <= longest) return value;
    this.fault(key, `a text of 1 to ${longest} characters`);
    return fallback;
  }
}
