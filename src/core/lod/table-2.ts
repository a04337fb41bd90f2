/** Ranges of the paper's Table 2 in metres. */
export const TABLE_RANGES = [5, 30, 60, 120, 240, 600, 1200] as const;

/** The rows of Table 2 in its order. */
export const TABLE_ROWS = [
  'trunkTriangles',
  'trunkLines',
  'mainTriangles',
  'mainLines',
  'otherTriangles',
  'otherLines',
  'leafTriangles',
  'leafPoints',
] as const;
export type TableRow = (typeof TABLE_ROWS)[number];

/** Elements drawn at each range on the quaking aspen in summer. Source: Weber & Penn 1995, Table 2. */
export const TABLE_2: Readonly<Record<TableRow, readonly number[]>> = {
  trunkTriangles: [1440, 1440, 1440, 1440, 1440, 760, 0],
  trunkLines: [0, 0, 0, 36, 36, 36, 36],
  mainTriangles: [960, 960, 960, 0, 0, 0, 0],
  mainLines: [240, 240, 240, 223, 153, 35, 0],
  otherTriangles: [17736, 14580, 0, 0, 0, 0, 0],
  otherLines: [5912, 5912, 5363, 2648, 0, 0, 0],
  leafTriangles: [53248, 53248, 49800, 28200, 0, 0, 0],
  leafPoints: [13312, 13312, 13312, 13312, 11944, 1664, 1664],
};
