/**
 * Factors on a leaf's width and length where only `fraction` of the leaves is drawn, so that they cover as much: narrow
 * leaves grow in width first, since a willow with broad leaves is still a willow and one with long leaves is not.
 */
export function leafGrowth(fraction: number, widthOverLength: number): [width: number, length: number] {
  const narrow = Math.min(1, Math.max(0, 1 - widthOverLength));
  const share = 0.5 + 0.25 * narrow;
  return [fraction ** -share, fraction ** -(1 - share)];
}
