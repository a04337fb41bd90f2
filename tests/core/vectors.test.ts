import { describe, expect, test } from 'vitest';
import vectors from '../fixtures/vectors.json' with { type: 'json' };
import type { Adapters } from './vectors/case.ts';
import { deform } from './vectors/deform.ts';
import { grow } from './vectors/grow.ts';
import { later } from './vectors/later.ts';
import { lod } from './vectors/lod.ts';
import { math } from './vectors/math.ts';
import { pieces } from './vectors/pieces.ts';
import { wind } from './vectors/wind.ts';

/**
 * Numeric cases of the papers' corrected equations, in double precision. To add a function: an adapter in tests/core/vectors/, from
 * the input of its cases to their output.
 */
const adapters: Adapters = { ...math, ...deform, ...wind, ...pieces, ...grow, ...lod };

interface Case {
  name: string;
  fn: string;
  in: unknown;
  out: Record<string, unknown>;
  tol: number;
}

const cases = vectors.cases as Case[];

/** Numbers within tol * max(1, |expected|), lists and objects part by part, all else equal; gives the first place that differs. */
function difference(got: unknown, want: unknown, tolerance: number, path: string): string | undefined {
  if (typeof want === 'number') {
    const fine = typeof got === 'number' && Math.abs(got - want) <= tolerance * Math.max(1, Math.abs(want));
    return fine ? undefined : `${path}: ${String(got)} is not ${want}`;
  }
  if (Array.isArray(want)) {
    if (!Array.isArray(got) || got.length !== want.length)
      return `${path}: ${JSON.stringify(got)} is not a list of ${want.length}`;
    for (let i = 0; i < want.length; i++) {
      const found = difference(got[i], want[i], tolerance, `${path}[${i}]`);
      if (found !== undefined) return found;
    }
    return undefined;
  }
  if (typeof want === 'object' && want !== null) {
    for (const [key, value] of Object.entries(want)) {
      const found = difference((got as Record<string, unknown>)[key], value, tolerance, `${path}.${key}`);
      if (found !== undefined) return found;
    }
    return undefined;
  }
  return got === want ? undefined : `${path}: ${String(got)} is not ${String(want)}`;
}

describe('vectors', () => {
  test('there is an adapter for every function that is built', () => {
    const unknown = cases.map(({ fn }) => fn).filter((fn) => !(fn in adapters) && !later.includes(fn));
    expect([...new Set(unknown)]).toEqual([]);
  });

  test('nothing is said to be built later that is built or that no case asks for', () => {
    expect(later.filter((fn) => fn in adapters || !cases.some((c) => c.fn === fn))).toEqual([]);
  });

  test.each(cases.filter(({ fn }) => fn in adapters))('$name', ({ fn, in: input, out, tol }) => {
    expect(difference(adapters[fn](input as never), out, tol, fn)).toBeUndefined();
  });
});
