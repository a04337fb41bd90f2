import type { Season } from '../species/season.ts';

/** What of an item is drawn as surfaces and what as lines or points: parts of the whole, 0..1. Both begin with the first element. */
export interface Fraction {
  readonly polygons: number;
  /** Lines of stems, points of leaves. */
  readonly thin: number;
}

/** The four descriptions of a tree that degrade each by a rule of its own; stems deeper than `other` go with it. */
export interface Fractions {
  readonly trunk: Fraction;
  readonly main: Fraction;
  readonly other: Fraction;
  readonly leaves: Fraction;
}

export type Item = keyof Fractions;

export interface FractionOptions {
  /** 0..1 by the paper; default 1. More is finer. */
  readonly quality?: number;
  readonly season?: Season;
  readonly evergreen?: boolean;
  /** Bridges the printed jumps over a little more range. Default false: as printed. */
  readonly eased?: boolean;
}

/** Elements of a mass of leaf points: one of each is always drawn (weber-penn.md 1.3: Table 2 fits with 8 only). */
export const POINT_MASS = 8;

/** Ranges beyond a printed jump, as a part of it, over which an eased fraction gets to the other side. None reaches a range of Table 2. */
const EASE = { trunkLines: 0.1, mainPolygons: 0.15, trunkPolygons: 0.125 } as const;

const clamp = (x: number): number => Math.min(1, Math.max(0, x));

/** How far `r2` has come from `at` to the end of the band after it, 0..1; all the way at once where nothing is eased. */
const past = (r2: number, at: number, band: number, eased: boolean): number =>
  eased ? clamp((r2 - at) / (band * at)) : r2 > at ? 1 : 0;

/** Scales of the rules in metres of r2: s for stems, d for leaves. Source: Weber & Penn 1995, section 5. */
export function rangeScales({ quality = 1, season = 'summer', evergreen = false }: FractionOptions = {}): {
  readonly s: number;
  readonly d: number;
} {
  const leafy = evergreen || season === 'summer' || season === 'autumn';
  return { s: leafy ? quality / 2 : quality, d: season === 'spring' ? 100 : 200 };
}

/** What is drawn at a calibrated range. Source: Weber & Penn 1995, section 5; weber-penn.md 1.3 for what the scan lost. */
export function fractions(r2: number, options: FractionOptions = {}): Fractions {
  const { s, d } = rangeScales(options);
  return fractionsAt(r2, s, d, options.eased ?? false);
}

/** The same from the scales themselves. */
export function fractionsAt(r2: number, s: number, d: number, eased: boolean): Fractions {
  const slope = clamp(1.5 - r2 / 600); // section 5, levels 0 and 1: polygons
  return {
    trunk: {
      polygons: slope * (1 - past(r2, 800, EASE.trunkPolygons, eased)), // section 5, level 0: none beyond 800
      thin: past(r2, 100, EASE.trunkLines, eased), // section 5, level 0: no lines near by, where they show as a seam
    },
    main: {
      polygons: slope * (1 - past(r2, 200 * s, EASE.mainPolygons, eased)), // section 5, level 1
      thin: r2 <= 200 * s ? 1 : r2 > 2000 * s ? 0 : clamp(2.2 - 1.2 * (r2 / (200 * s)) ** 0.3), // section 5, level 1
    },
    other: {
      polygons: clamp(2 - r2 / (50 * s)), // section 5, level 2: 1 below 50 s, 0 above 100 s
      thin: r2 > 500 * s ? 0 : clamp(2 - Math.sqrt(r2 / (100 * s))), // section 5, level 2
    },
    leaves: {
      polygons: clamp(4 / 3 - r2 / (0.75 * d)), // section 5, leaves: 1 below d/4, 0 above d
      thin: clamp(1.5 - r2 / (2 * d)), // section 5, leaves: 1 below d; `leafPrefixes` keeps one a mass
    },
  };
}

/** A place where a printed fraction jumps: from `before` to `after` as r2 passes `at`. */
export interface Jump {
  readonly item: Item;
  readonly as: keyof Fraction;
  readonly at: number;
  readonly before: number;
  readonly after: number;
}

/** All jumps that the printed rules have for these options; eased ones have none. */
export function printedJumps(options: FractionOptions = {}): Jump[] {
  const { s } = rangeScales(options);
  const jumps: Jump[] = [
    { item: 'trunk', as: 'thin', at: 100, before: 0, after: 1 },
    { item: 'trunk', as: 'polygons', at: 800, before: 1.5 - 800 / 600, after: 0 },
    { item: 'main', as: 'polygons', at: 200 * s, before: clamp(1.5 - (200 * s) / 600), after: 0 },
  ];
  return jumps.filter(({ before, after }) => before !== after);
}
