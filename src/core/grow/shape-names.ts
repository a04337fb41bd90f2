/** Shape ids of the paper, 0..8, and Windgrove's 9 (row 10). */
export const SHAPES = [
  'conical',
  'spherical',
  'hemispherical',
  'cylindrical',
  'tapered cylindrical',
  'flame',
  'inverse conical',
  'tend flame',
  'envelope',
  'cone',
] as const;
