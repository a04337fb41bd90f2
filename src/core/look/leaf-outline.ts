/**
 * Points (x, z) of the right half of a blade, from its base (0, 0) along the margin to the tip (0, 1): x is the distance from the midrib as a fraction of the whole width (0..0.5), z runs
 * along the midrib. Of two points, one of them on the midrib: a triangle that is not folded.
 */
export type HalfOutline = readonly (readonly [number, number])[];

/** How finely a leaf is drawn. */
export type LeafGrain = 'near' | 'middle' | 'far';

/** The outline of a blade: `near` reads at arm's length, `middle` and `far` keep about the same area in few triangles. */
export interface BladeOutline {
  readonly name: string;
  readonly near: HalfOutline;
  readonly middle: HalfOutline;
  readonly far: HalfOutline;
}

/** Area of a whole blade whose width and length are 1. */
export function outlineArea(half: HalfOutline): number {
  let twice = 0;
  for (let i = 0; i + 1 < half.length; i++) {
    const [x0, z0] = half[i]!;
    const [x1, z1] = half[i + 1]!;
    twice += (x0 + x1) * (z1 - z0);
  }
  return twice;
}

/** `coarse` made so wide that it covers as much as `near`. */
export function asWide(near: HalfOutline, coarse: HalfOutline): HalfOutline {
  const factor = outlineArea(near) / outlineArea(coarse);
  return coarse.map(([x, z]) => [x * factor, z] as const);
}

/** An outline whose coarser grains are made to cover as much as the finest. */
export const outline = (name: string, near: HalfOutline, middle: HalfOutline, far: HalfOutline): BladeOutline => ({
  name,
  near,
  middle: asWide(near, middle),
  far: asWide(near, far),
});
