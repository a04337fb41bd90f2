/** Pixels of height from which a tree is drawn in full, and from which it is more than a picture of itself. */
export const NEAR_PIXELS = 260;
export const MIDDLE_PIXELS = 70;

/** Part of a threshold to each side of it over which both classes share a tree out. */
export const BAND = 0.15;

/** A class is asked for before its first pixel shows and given up well after its last one, as parts of that first pixel's size. */
const ASK = 0.92;
const LEAVE = 0.78;

/** Pixels of a class's thresholds. */
export interface Thresholds {
  readonly near: number;
  readonly middle: number;
}

export const THRESHOLDS: Thresholds = { near: NEAR_PIXELS, middle: MIDDLE_PIXELS };

/** Where a finer class begins to show and where it has taken over, pixels; `wide`: factor on the band between, 0 for a hard switch. */
export const bandOf = (threshold: number, wide = 1): [from: number, to: number] => [
  threshold * (1 - BAND * wide),
  threshold * (1 + BAND * wide),
];

/** Is a class wanted of something `pixels` high that was (`before`) or was not? A camera that trembles on the threshold changes nothing. */
export const isWanted = (pixels: number, threshold: number, before: boolean): boolean =>
  pixels > bandOf(threshold)[0] * (before ? LEAVE : ASK);
