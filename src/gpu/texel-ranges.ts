/** Corners of a rectangle of texels: x0, y0 (inside), x1, y1 (outside). */
export type TexelRectangle = readonly [x0: number, y0: number, x1: number, y1: number];

/**
 * The texels of the indices [start, end) as one to three rectangles: the end of a row, whole rows, the beginning of a row.
 *
 * Index i lies at (i mod width, floor(i / width)). No texel is in two rectangles; none where end <= start.
 */
export function texelRectangles(start: number, end: number, width: number): TexelRectangle[] {
  if (end <= start) return [];
  const x0 = start % width;
  const y0 = Math.floor(start / width);
  const x1 = end % width;
  const y1 = Math.floor(end / width);
  if (y0 === y1) return [[x0, y0, x1, y0 + 1]];
  const rectangles: TexelRectangle[] = [];
  const firstWholeRow = x0 === 0 ? y0 : y0 + 1;
  if (x0 > 0) rectangles.push([x0, y0, width, y0 + 1]);
  if (y1 > firstWholeRow) rectangles.push([0, firstWholeRow, width, y1]);
  if (x1 > 0) rectangles.push([0, y1, x1, y1 + 1]);
  return rectangles;
}
