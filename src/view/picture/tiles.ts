import type { PictureSize } from './picture.ts';

/** A part of a picture that is drawn at once, in its pixels from the upper left. */
export interface Tile extends PictureSize {
  readonly x: number;
  readonly y: number;
}

/** Pixels that are drawn at once at most: with four samples and a depth each they take a quarter of a gigabyte. */
const MOST_PIXELS = 2 ** 23;

/** The parts in which a picture is drawn: none with a side longer than `longest`, all of them together the whole, without overlap. */
export function tilesOf({ width, height }: PictureSize, longest: number): readonly Tile[] {
  let columns = Math.ceil(width / longest);
  let rows = Math.ceil(height / longest);
  while (Math.ceil(width / columns) * Math.ceil(height / rows) > MOST_PIXELS) {
    if (width / columns >= height / rows) columns++;
    else rows++;
  }
  const tiles: Tile[] = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const x = Math.floor((width * column) / columns);
      const y = Math.floor((height * row) / rows);
      const right = Math.floor((width * (column + 1)) / columns);
      const bottom = Math.floor((height * (row + 1)) / rows);
      tiles.push({ x, y, width: right - x, height: bottom - y });
    }
  }
  return tiles;
}
