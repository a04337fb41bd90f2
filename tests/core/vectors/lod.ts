import { type Fractions, fractionsAt } from '../../../src/core/lod/fractions.ts';
import { massesDrawn } from '../../../src/core/lod/masses.ts';
import type { Adapters } from './case.ts';

const FRACTION: Readonly<Record<string, (f: Fractions) => number>> = {
  poly0: (f) => f.trunk.polygons,
  line0: (f) => f.trunk.thin,
  poly1: (f) => f.main.polygons,
  line1: (f) => f.main.thin,
  poly2: (f) => f.other.polygons,
  line2: (f) => f.other.thin,
  polyL: (f) => f.leaves.polygons,
  pointL: (f) => f.leaves.thin,
};

/** Degradation at range. */
export const lod: Adapters = {
  lod: ({ item, r2, s, d }: { item: string; r2: number[]; s: number; d: number }) => {
    const of = FRACTION[item];
    if (!of) throw new Error(`no item ${item}`);
    return { fraction: r2.map((range) => of(fractionsAt(range, s, d, false))) };
  },
  lod_drawn: ({ total, mass, number }: { total: number; mass: number; number: number }) => ({
    drawn: massesDrawn(total, mass, number),
  }),
};
