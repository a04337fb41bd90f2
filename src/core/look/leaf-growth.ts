import { hasMargin, type LeafSpec } from './leaf-spec.ts';

/**
 * Area that remaining leaves make up for, as a power of the fraction that is drawn. Below 1, because leaves hang in clumps and cover each
 * other there: fewer of them overlap less. At 1 a tenth of an aspen's leaves covers 9 % too much; tests/core/lod/cover.test.ts.
 */
const MADE_UP = 0.965;

/**
 * Factors on a leaf's width and length where only `fraction` of the leaves is drawn, so that they cover as much: narrow
 * leaves grow in width first, since a willow with broad leaves is still a willow and one with long leaves is not.
 */
export function leafGrowth(fraction: number, widthOverLength: number): [width: number, length: number] {
  const narrow = Math.min(1, Math.max(0, 1 - widthOverLength));
  const share = 0.5 + 0.25 * narrow;
  return [fraction ** (-MADE_UP * share), fraction ** (-MADE_UP * (1 - share))];
}

/** Shapes whose needles stand about an axis: rosette, bundle, sprig. */
const ROUND: readonly number[] = [12, 13, 14];

/** How much more alike to all sides those grow than flat leaves, 0..1: fitted to what they cover, as MADE_UP is. */
const ALIKE = 0.2;

/** The width over the length by which leaves are to grow: of needles all around, those to the sides would cover less if width alone grew. */
export const growthWidth = ({ shape, margin, width }: LeafSpec): number =>
  ROUND.includes(shape) && !hasMargin(margin) ? width + ALIKE * (1 - width) : width;
