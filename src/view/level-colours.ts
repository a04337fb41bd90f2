/** Colours of the stems by level, sRGB: the same in plots, text and pictures. */
export const LEVEL_COLOURS = ['#7a4a1e', '#b5651d', '#d9a441', '#8fbf3f'] as const;

/** The colour of a level; deeper ones use the last. */
export const levelColour = (level: number): string =>
  LEVEL_COLOURS[Math.min(level, LEVEL_COLOURS.length - 1)] as string;
