/** The number of clones to make now, and the error that is left over (Weber & Penn 1995, 4.2; row 29). */
export const effectiveSplits = (segSplits: number, error: number): number =>
  Math.max(0, Math.floor(segSplits + error + 0.5));

/** Clones at the ends of `count` segments, error diffusion from 0 on. */
export function splitSequence(segSplits: number, count: number): number[] {
  const splits: number[] = [];
  let error = 0;
  for (let i = 0; i < count; i++) {
    const n = effectiveSplits(segSplits, error);
    error -= n - segSplits;
    splits.push(n);
  }
  return splits;
}

/**
 * Stems that one stem with its clones becomes: clones inherit the error of their twin (row 29), so all split in step.
 * `first` is the number of clones at the end of the first segment where it is given apart (base splits), else -1.
 */
export function familySize(
  segSplits: number,
  error: number,
  segments: number,
  first: number,
  halving: boolean,
): number {
  let size = 1;
  let left = error;
  let rate = segSplits;
  for (let i = 0; i < segments - 1; i++) {
    let n = first;
    if (i > 0 || first < 0) {
      n = effectiveSplits(rate, left);
      left -= n - rate;
    }
    size *= n + 1;
    if (halving && n > 0) rate *= 0.5;
  }
  return size;
}

/** max(0, (nSplitAngle +- V) - declination), one unit for all (4.2; weber-penn.md 1.1). */
export const splitAngle = (angle: number, declination: number): number => Math.max(0, angle - declination);

/**
 * How far a single clone turns about the vertical through the split, in degrees: 20 + F (30 + |declination - 90|) R^2 with R uniform in
 * 0..1 (4.2; row 35). F is 0.75 as printed; the 50 and 140 degrees of the paper's text need 1.
 */
export const spreadAngleDeg = (declinationDeg: number, random: number, factor: number): number =>
  20 + factor * (30 + Math.abs(declinationDeg - 90)) * random * random;
