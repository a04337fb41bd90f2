/**
 * r2: the range that the rules of degradation are written for, metres of a picture 1000 rows high that spans 60 degrees. A long lens brings
 * a tree nearer, a small picture puts it farther away.
 *
 * `range` in metres, `imageHeight` in pixels, `fov` vertically in degrees. Source: Weber & Penn 1995, section 5.
 */
export const calibratedRange = (range: number, imageHeight: number, fov: number): number =>
  ((range * 1000) / imageHeight) * (fov / 60);
