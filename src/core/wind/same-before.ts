import { gustArrival } from './gust.ts';
import { ORIGIN, type Placement, TREE_REACH } from './place.ts';
import { blowingWaves, type Gust, type Wind } from './wind.ts';

/** Are two values of documents (numbers, words, lists, plain objects) the same in every field? */
export function sameValue(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false;
  const [keys, others] = [Object.keys(a), Object.keys(b)];
  const [x, y] = [a as Record<string, unknown>, b as Record<string, unknown>];
  return keys.length === others.length && keys.every((key) => Object.hasOwn(b, key) && sameValue(x[key], y[key]));
}

/** What of a wind is felt, without its gusts and names. */
const felt = (wind: Wind) => {
  const { name: _, description: __, gusts: ___, waves: ____, ...rest } = wind;
  return {
    ...rest,
    waves: blowingWaves(wind)
      .filter(({ amplitude }) => amplitude > 0)
      .map((wave) => ({ ...wave, on: true, solo: false })),
  };
};

/** The gusts of a that b has not; two that are alike are two. */
function gustsWithout(a: readonly Gust[], b: readonly Gust[]): Gust[] {
  const rest = [...b];
  return a.filter((gust) => {
    const i = rest.findIndex((other) => sameValue(gust, other));
    if (i >= 0) rest.splice(i, 1);
    return i < 0;
  });
}

/**
 * Do two winds bend a tree that stands at `place` the same at all times before `time` (seconds)? They do where they differ only in gusts
 * whose fronts come later to the first of its twigs (`reach` before its place), in names, and in waves that do not blow.
 */
export function sameBefore(
  a: Wind,
  b: Wind,
  time: number,
  { x, y, reach = TREE_REACH }: Readonly<Omit<Placement, 'yaw'>> = ORIGIN,
): boolean {
  if (a === b) return true;
  const apart = [...gustsWithout(a.gusts, b.gusts), ...gustsWithout(b.gusts, a.gusts)];
  const later = (gust: Gust) => !(gust.amplitude > 0) || gustArrival(gust, x, y) - reach / gust.speed >= time;
  return apart.every(later) && sameValue(felt(a), felt(b));
}
