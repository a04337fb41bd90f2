/** A square patch of ground: its low corner and side, forest space, metres. */
export interface Tile {
  readonly x: number;
  readonly y: number;
  readonly side: number;
  /** Lies within the forest's square. */
  readonly inside: boolean;
}

/** Tiles a side of the square. */
const TILES = 8;

/** Tiles of the square, and around it two rings of ever larger ones: the land that the forest lies in. */
export function terrainTiles(size: number): Tile[] {
  const tiles: Tile[] = [];
  const side = size / TILES;
  for (let j = 0; j < TILES; j++) {
    for (let i = 0; i < TILES; i++) tiles.push({ x: i * side - size / 2, y: j * side - size / 2, side, inside: true });
  }
  for (const ring of [size, 3 * size]) {
    for (let j = -1; j <= 1; j++) {
      for (let i = -1; i <= 1; i++) {
        if (i || j) tiles.push({ x: (i - 0.5) * ring, y: (j - 0.5) * ring, side: ring, inside: false });
      }
    }
  }
  return tiles;
}

/** Cells a side of a patch: near, in the middle, far. */
export const PATCH_CELLS = [32, 16, 8] as const;

/** How finely a tile of the square is drawn whose nearest point is `distance` metres away, as an index of PATCH_CELLS. */
export function tileDetail({ side }: Tile, distance: number): 0 | 1 | 2 {
  return distance < 1.2 * side ? 0 : distance < 3 * side ? 1 : 2;
}
