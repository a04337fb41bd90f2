import { BUNDLE } from './spread.ts';

/** Runs that a tree's part of the order is cut into at least: what is left out of a prefix of it is less than one of them. */
const RUNS = 64;
/** Of a rank 0..1 as a whole number beside a tree's index: together they are exact in a double. */
const FINE = 1_099_511_627_776;
const TREES = 2048;
const GOLDEN = 0.6180339887498949;

/**
 * Shares out the places of a draw order among trees that have `counts` things each, in an order of their own: any prefix holds the same
 * part of every tree, to within a sixty-fourth of it.
 *
 * Neighbours stay together as far as that goes, for the texture cache's sake. `run` is told a tree, its first thing, how many things follow
 * one another, and the place that they come to.
 */
export function shareOut(
  counts: readonly number[],
  run: (tree: number, first: number, count: number, at: number) => void,
): void {
  const runOf = counts.map((n) => Math.min(BUNDLE, Math.max(1, Math.floor(n / RUNS))));
  const keys: number[] = [];
  counts.forEach((n, tree) => {
    const runs = Math.ceil(n / (runOf[tree] as number));
    // Trees of one size would take turns in bunches: each begins at a place of its own.
    const own = (tree * GOLDEN) % 1;
    for (let k = 0; k < runs; k++) keys.push(Math.floor(((k + own) / runs) * FINE) * TREES + tree);
  });
  const sorted = Float64Array.from(keys).sort();
  const next = counts.map(() => 0);
  let at = 0;
  for (const key of sorted) {
    const tree = key % TREES;
    const first = next[tree] as number;
    const count = Math.min(runOf[tree] as number, (counts[tree] as number) - first);
    run(tree, first, count, at);
    next[tree] = first + count;
    at += count;
  }
}
