import type { TreePlaces } from '../../core/forest/forest.ts';

/** Sides of the cells whose trees make a grove, metres: nine near ones fill a middle one. */
export const NEAR_CELL = 12;
export const MIDDLE_CELL = 36;

/** A square of ground and the trees on it. */
export interface Cell {
  readonly index: number;
  /** Middle, forest space, metres. */
  readonly x: number;
  readonly y: number;
  /** Ranks of its trees by species (index in the mix), each list nearest to the first rank first. */
  readonly bySpecies: ReadonlyMap<number, readonly number[]>;
  readonly count: number;
  /** Of the ground under its trees, metres. */
  readonly low: number;
  readonly high: number;
  /** Height of its tallest tree, metres. */
  readonly tallest: number;
}

/** Cells over a square of ground; index = row * columns + column, from -x, -y. */
export interface CellGrid {
  readonly side: number;
  readonly columns: number;
  /** Low corner of the first cell, x and y. */
  readonly origin: number;
  /** Those with trees. */
  readonly cells: readonly Cell[];
}

/** Cells a row for a square of `size` metres, so that grids of both sides begin at the same corner. */
const middleColumns = (size: number): number => Math.max(1, Math.ceil(size / MIDDLE_CELL));

/** The column (or row) of a coordinate. */
const columnOf = (at: number, origin: number, side: number, columns: number): number =>
  Math.min(columns - 1, Math.max(0, Math.floor((at - origin) / side)));

/** Sorts the first `count` trees into cells of `side` metres, NEAR_CELL or MIDDLE_CELL. `heights`: metres, one a tree. */
export function cellGrid(
  places: TreePlaces,
  count: number,
  heights: ArrayLike<number>,
  size: number,
  side: number,
): CellGrid {
  const middle = middleColumns(size);
  const columns = middle * Math.round(MIDDLE_CELL / side);
  const origin = (-middle * MIDDLE_CELL) / 2;
  const members = new Map<number, number[]>();
  for (let i = 0; i < count; i++) {
    const column = columnOf(places.x[i] as number, origin, side, columns);
    const row = columnOf(places.y[i] as number, origin, side, columns);
    const index = row * columns + column;
    const list = members.get(index);
    if (list) list.push(i);
    else members.set(index, [i]);
  }
  const cells = [...members].map(([index, ranks]): Cell => {
    const bySpecies = new Map<number, number[]>();
    let low = Number.POSITIVE_INFINITY;
    let high = Number.NEGATIVE_INFINITY;
    let tallest = 0;
    for (const i of ranks) {
      const species = places.species[i] as number;
      const list = bySpecies.get(species);
      if (list) list.push(i);
      else bySpecies.set(species, [i]);
      low = Math.min(low, places.z[i] as number);
      high = Math.max(high, places.z[i] as number);
      tallest = Math.max(tallest, heights[i] as number);
    }
    const x = origin + ((index % columns) + 0.5) * side;
    const y = origin + (Math.floor(index / columns) + 0.5) * side;
    return { index, x, y, bySpecies, count: ranks.length, low, high, tallest };
  });
  return { side, columns, origin, cells };
}

/** Metres from a point to the nearest place of a cell where a tree may be. */
export function distanceToCell(cell: Cell, side: number, x: number, y: number, z: number): number {
  const half = side / 2;
  const dx = Math.max(0, Math.abs(x - cell.x) - half);
  const dy = Math.max(0, Math.abs(y - cell.y) - half);
  const dz = Math.max(0, cell.low - z, z - cell.high - cell.tallest);
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}
