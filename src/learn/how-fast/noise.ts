import { combine, hashUnit } from '../../core/math/hash.ts';

/** Milliseconds that two programs take in each round, on a machine that does other things as well. */
export interface Rounds {
  readonly a: readonly number[];
  readonly b: readonly number[];
}

/** What they take alone. */
export const ALONE = { a: 10, b: 15 } as const;

const drawn = (path: number, number: number): number => hashUnit(combine(path, number));

/**
 * Rounds of two programs beside other work that takes up to `load` of the machine, the same for the same arguments. `turns`: A and B of a round run one after
 * the other, so that slow spells meet both; else all of A runs before all of B.
 */
export function rounds(count: number, load: number, turns: boolean): Rounds {
  const spell = (time: number): number => {
    // A slow spell that comes and goes, now and then a hiccup, and a little noise.
    const slow = 0.5 - 0.5 * Math.cos((2 * Math.PI * (time + 0.06)) / 1.35);
    const hiccup = drawn(77, Math.round(time * 1e4)) > 0.86 ? 1.6 : 0;
    return 1 + load * (slow + hiccup + 0.08 * drawn(78, Math.round(time * 1e4)));
  };
  const at = (i: number, second: boolean): number =>
    turns ? (i + (second ? 0.5 : 0)) / count : (i / count + (second ? 1 : 0)) / 2;
  const all = (base: number, second: boolean): number[] =>
    Array.from({ length: count }, (_, i) => base * spell(at(i, second)));
  return { a: all(ALONE.a, false), b: all(ALONE.b, true) };
}

export const mean = (values: readonly number[]): number => values.reduce((sum, x) => sum + x, 0) / values.length;
export const median = (values: readonly number[]): number =>
  values.toSorted((a, b) => a - b)[values.length >> 1] ?? Number.NaN;

/** How many times as long B takes: by means, by medians, and by the median of the rounds' own ratios. */
export function ratiosOf({ a, b }: Rounds): { means: number; medians: number; byRound: number } {
  return {
    means: mean(b) / mean(a),
    medians: median(b) / median(a),
    byRound: median(b.map((time, i) => time / (a[i] as number))),
  };
}
