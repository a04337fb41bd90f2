import { decode } from 'fast-png';
import type { Fault } from '../file/fault.ts';
import { oneLine } from '../file/one-line.ts';

/** A square grey picture, as heights and densities are read from. */
export interface GreyMap {
  /** Pixels of a side. */
  readonly side: number;
  /** 0 black .. 1 white; side x side, x fastest, the bottom row of the picture first: y goes up to the north. */
  readonly values: Float32Array;
}

export type ReadMap =
  | { readonly map: GreyMap; readonly fault?: undefined }
  | { readonly map?: undefined; readonly fault: Fault };

/** Pixels of a side. */
export const MAP_SIDES = [2, 2049] as const;

/** Bytes of a file: a picture of the largest size, packed badly. */
export const LONGEST_MAP = 40_000_000;

const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10];
const SIZES = `a square of ${MAP_SIDES[0]} to ${MAP_SIDES[1]} pixels a side`;

/** How far apart red, green and blue of a pixel may be for it to be grey, of the whole range. */
const NEARLY_GREY = 0.02;

/** Passes of `soften`: each reaches a pixel farther, and the steps of a gentle slope are some ten pixels wide. */
const PASSES = 12;

/** A height map: a square grey PNG of 8 or 16 bit. `name` is the file's, for the message. Never throws. */
export function readHeightMap(bytes: Uint8Array, name: string): ReadMap {
  const { map, coarse, fault } = readGrey(bytes, name, 'a height map');
  if (fault) return { fault };
  return { map: coarse ? soften(map) : map };
}

/** A density map: a square grey PNG of 8 or 16 bit, black bare and white full of trees. Never throws. */
export function readDensityMap(bytes: Uint8Array, name: string): ReadMap {
  const { map, fault } = readGrey(bytes, name, 'a density map');
  return fault ? { fault } : { map };
}

type Grey =
  | { map: GreyMap; coarse: boolean; fault?: undefined }
  | { map?: undefined; coarse?: undefined; fault: Fault };

function readGrey(bytes: Uint8Array, name: string, kind: string): Grey {
  const broken = (found: string, allowed: string): Grey => ({
    fault: { path: oneLine(name) || kind, found, allowed: `${kind}: ${allowed}` },
  });
  if (bytes.length === 0) return broken('an empty file', 'a grey PNG picture');
  if (SIGNATURE.some((byte, i) => bytes[i] !== byte))
    return broken('no PNG picture', 'a grey PNG picture of 8 or 16 bit');
  if (bytes.length > LONGEST_MAP) return broken(`${bytes.length} bytes`, `up to ${LONGEST_MAP} bytes`);
  if (bytes.length < 33) return broken('a PNG picture that ends in its head', 'a whole PNG picture');
  // The size is asked of the head: a small file can unpack to more than there is memory.
  const head = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const width = head.getUint32(16);
  const height = head.getUint32(20);
  if (width !== height) return broken(`${width} x ${height} pixels, not a square`, SIZES);
  if (width < MAP_SIDES[0] || width > MAP_SIDES[1]) return broken(`${width} x ${height} pixels`, SIZES);
  try {
    return greyOf(decode(bytes), broken);
  } catch (error) {
    const why = error instanceof Error ? oneLine(reasonOf(error), 80) : 'unknown';
    return broken(`a PNG picture that is damaged (${why})`, 'a whole PNG picture');
  }
}

/** What an error says: a message of the decoder that ends in a colon goes on in its cause, or is whole without the colon. */
function reasonOf({ message, cause }: Error): string {
  const more = cause instanceof Error ? cause.message : typeof cause === 'string' ? cause : '';
  if (!message.endsWith(':')) return message;
  return more === '' ? message.slice(0, -1) : `${message} ${more}`;
}

type Picture = ReturnType<typeof decode>;

function greyOf(picture: Picture, broken: (found: string, allowed: string) => Grey): Grey {
  const { width: side, data, depth, palette } = picture;
  const channels = picture.channels;
  const pixels = side * side;
  if (data.length < (depth < 8 ? (pixels * depth * channels) / 8 : pixels * channels))
    return broken('a PNG picture that ends too early', 'a whole PNG picture');
  const white = 2 ** depth - 1;
  const values = new Float32Array(pixels);
  for (let row = 0; row < side; row++) {
    const up = (side - 1 - row) * side;
    for (let column = 0; column < side; column++) {
      const at = (row * side + column) * channels;
      const grey = palette
        ? greyOfColour(palette[sample(data, row, column, side, depth)] ?? [0, 0, 0], 255)
        : channels < 3
          ? sample(data, row, column * channels, side * channels, depth) / white
          : greyOfColour([data[at]!, data[at + 1]!, data[at + 2]!], white);
      if (grey === undefined)
        return broken(`a coloured picture (pixel ${column}, ${row} from the top left)`, 'shades of grey alone');
      values[up + column] = grey;
    }
  }
  return { map: { side, values }, coarse: depth <= 8 };
}

/** A value of a row of `perRow`: those of less than 8 bit are packed, each row from a byte of its own. */
function sample(data: Picture['data'], row: number, index: number, perRow: number, depth: number): number {
  if (depth >= 8) return data[row * perRow + index]!;
  const bit = index * depth;
  const byte = data[row * Math.ceil((perRow * depth) / 8) + (bit >> 3)]!;
  return (byte >> (8 - depth - (bit & 7))) & ((1 << depth) - 1);
}

function greyOfColour([r = 0, g = 0, b = 0]: readonly number[], white: number): number | undefined {
  const apart = Math.max(r, g, b) - Math.min(r, g, b);
  return apart > NEARLY_GREY * white ? undefined : (r + g + b) / 3 / white;
}

/** Takes the steps out of 8 bit: each value goes where its neighbours are, by no more than what rounding took from it. */
function soften({ side, values }: GreyMap): GreyMap {
  const half = 0.5 / 255;
  let from = values;
  for (let pass = 0; pass < PASSES; pass++) {
    const to = new Float32Array(values.length);
    for (let j = 0; j < side; j++) {
      const south = Math.max(0, j - 1) * side;
      const north = Math.min(side - 1, j + 1) * side;
      for (let i = 0; i < side; i++) {
        const at = j * side + i;
        const west = i > 0 ? at - 1 : at;
        const east = i < side - 1 ? at + 1 : at;
        const mean = (from[west]! + from[east]! + from[south + i]! + from[north + i]!) / 4;
        to[at] = Math.min(values[at]! + half, Math.max(values[at]! - half, mean));
      }
    }
    from = to;
  }
  return { side, values: from };
}
