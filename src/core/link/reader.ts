import { LINK_NUMBERS } from './numbers.ts';
import { allowed, type NumberRule, readNumber } from './rule.ts';

/** One value of a link that could not be used. */
export interface LinkFault {
  /** Where: a key of the link, or `w2 speed`, `cam distance`. */
  readonly key: string;
  /** What stood there, as it stood; text from outside, never markup. */
  readonly found: string;
  /** What may stand there, in words. */
  readonly allowed: string;
}

/** Takes the values of a link one by one: each that is wrong gives a fault and its fallback. */
export class LinkReader {
  readonly values: Map<string, string>;
  readonly faults: LinkFault[];
  /** Keys that were asked for: those that a link may have. */
  readonly known: Set<string>;
  readonly #prefix: string;

  constructor(values: Map<string, string>, faults: LinkFault[] = [], known = new Set<string>(), prefix = '') {
    this.values = values;
    this.faults = faults;
    this.known = known;
    this.#prefix = prefix;
  }

  /** Reads the keys that begin with `prefix`, under their names without it. */
  within(prefix: string): LinkReader {
    return new LinkReader(this.values, this.faults, this.known, prefix);
  }

  has(key: string): boolean {
    return this.values.has(this.#prefix + key);
  }

  take(key: string): string | undefined {
    const whole = this.#prefix + key;
    const value = this.values.get(whole);
    this.known.add(whole);
    this.values.delete(whole);
    return value;
  }

  fault(key: string, found: string, allowedWords: string): void {
    this.faults.push({ key: this.#prefix + key, found, allowed: allowedWords });
  }

  read<T>(key: string, fallback: T, allowedWords: string, parse: (text: string) => T | undefined): T {
    const text = this.take(key);
    if (text === undefined) return fallback;
    const value = parse(text);
    if (value === undefined) this.fault(key, text, allowedWords);
    return value ?? fallback;
  }

  number(key: string, rule: NumberRule, fallback: number): number {
    return this.read(key, fallback, allowed(rule), (text) => readNumber(rule, text));
  }

  /** A number of `LINK_NUMBERS` under its own key. */
  linkNumber(key: keyof typeof LINK_NUMBERS, fallback: number): number {
    return this.number(key, LINK_NUMBERS[key], fallback);
  }

  flag(key: string, fallback: boolean): boolean {
    return this.read(key, fallback, '0 or 1', (text) => (text === '1' ? true : text === '0' ? false : undefined));
  }

  choice<T extends string>(key: string, fallback: T, among: readonly T[]): T {
    return this.read(key, fallback, among.join(', '), (text) => among.find((entry) => entry === text));
  }

  /** A list of numbers, each bad one in its fallback's stead; null where it is no such list, or has no fallback. */
  list(key: string, text: string, rules: readonly NumberRule[], fallback?: readonly number[]): number[] | null {
    const parts = text.split(',');
    const numbers = rules.map((rule, i) => readNumber(rule, parts[i] ?? ''));
    if (parts.length !== rules.length || (!fallback && numbers.includes(undefined))) {
      const each = rules.map((r) => `${r.label} (${r.min} to ${r.max})`).join(', ');
      this.fault(key, text, `${rules.length} numbers: ${each}`);
      return null;
    }
    return numbers.map((value, i) => {
      if (value === undefined) this.fault(`${key} ${rules[i]!.label}`, parts[i]!, allowed(rules[i]!));
      return value ?? fallback![i]!;
    });
  }

  /** A word of `among` and then numbers: `log,10,0.1,0.2`; null where it is none such, with a fault. */
  wordAndNumbers<T extends string>(
    key: string,
    among: readonly T[],
    rules: readonly NumberRule[],
    fallback: readonly number[],
  ): { word: T; numbers: number[] } | null {
    const text = this.take(key);
    if (text === undefined) return null;
    const [first = '', ...rest] = text.split(',');
    const word = among.find((entry) => entry === first);
    if (word === undefined || rest.length !== rules.length) {
      const each = rules.map((r) => `${r.label} (${r.min} to ${r.max})`).join(', ');
      this.fault(key, text, `${among.join(' or ')}, then ${each}`);
      return null;
    }
    const numbers = this.list(key, rest.join(), rules, fallback);
    return numbers && { word, numbers };
  }
}
