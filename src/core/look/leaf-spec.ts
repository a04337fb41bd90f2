import type { Species } from '../species/species.ts';

/** What a species' leaves are made from. */
export interface LeafSpec {
  /** 0 to 19. */
  readonly shape: number;
  /** Half widths of a free outline, which then takes the place of the shape. */
  readonly margin?: readonly number[] | undefined;
  /** Width and stalk in lengths of the whole: > 0 and >= 0. */
  readonly width: number;
  readonly petiole: number;
}

/** What the leaves of a species are made from. */
export const leafSpecOf = ({ foliage, leaves }: Pick<Species, 'foliage' | 'leaves'>): LeafSpec => ({
  shape: foliage.outline ?? leaves.shape,
  margin: foliage.margin,
  width: leaves.scaleX,
  petiole: leaves.petiole,
});

/** Whether the half widths of a leaf are an outline, which takes the place of its shape. */
export const hasMargin = (margin: readonly number[] | undefined): margin is readonly number[] =>
  margin !== undefined && margin.length > 1;
