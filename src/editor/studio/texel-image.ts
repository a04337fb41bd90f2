import type { TextureImages, TextureLayer } from '../../view/picture/picture.ts';

/** `colours`: x, y, z as red, green, blue. `much`: how far from rest, or how large, in one colour. */
export type TexelView = 'colours' | 'much';

/** What a number of a layer is, and how to say it. */
export interface LayerWords {
  readonly id: TextureLayer['id'];
  /** Names of the four numbers. */
  readonly names: readonly [string, string, string, string];
  readonly units: readonly [string, string, string, string];
  /** What `much` shows, its unit, and the token of its colour. */
  readonly much: string;
  readonly muchUnit: string;
  readonly colour: 'answer' | 'velocity';
}

const point = (id: 'P0' | 'P1' | 'P2' | 'P3', w: string, wUnit: string): LayerWords => ({
  id,
  names: ['x', 'y', 'z', w],
  units: ['m', 'm', 'm', wUnit],
  much: 'Moved from rest',
  muchUnit: 'm',
  colour: 'answer',
});

export const LAYER_WORDS: readonly LayerWords[] = [
  point('P0', 'O.x', ''),
  point('P1', 'O.y', ''),
  point('P2', 'O.z', ''),
  point('P3', 'leaves stirred', 'm'),
  {
    id: 'Q',
    names: ['bend T', 'bend S', 'velocity T', 'velocity S'],
    units: ['', '', '1/s', '1/s'],
    much: 'Bend',
    muchUnit: '',
    colour: 'answer',
  },
  {
    id: 'BASE',
    names: ['a.x', 'a.y', 'a.z', 'force'],
    units: ['m/s²', 'm/s²', 'm/s²', 'm'],
    much: 'Acceleration of the foot',
    muchUnit: 'm/s²',
    colour: 'velocity',
  },
  {
    id: 'END',
    names: ['a.x', 'a.y', 'a.z', 'bend L'],
    units: ['m/s²', 'm/s²', 'm/s²', ''],
    much: 'Acceleration of the end',
    muchUnit: 'm/s²',
    colour: 'velocity',
  },
];

export const wordsOf = (id: TextureLayer['id']): LayerWords => LAYER_WORDS.find((words) => words.id === id)!;

/**
 * How much each piece has moved from its rest (layers with a `rest`, laid out as the layer), or how large its value is: the length
 * of x, y, z, of a spring's bend that of the first two.
 */
export function amounts({ id, data }: TextureLayer, pieceCount: number, rest: Float32Array | null): Float32Array {
  return Float32Array.from({ length: pieceCount }, (_, i) => {
    const part = (k: number): number => data[4 * i + k]! - (rest ? rest[4 * i + k]! : 0);
    return id === 'Q' ? Math.hypot(part(0), part(1)) : Math.hypot(part(0), part(1), part(2));
  });
}

/** Least and greatest of each of x, y, z over the pieces. */
export function reach({ data }: TextureLayer, pieceCount: number): { low: number[]; high: number[] } {
  const low = [0, 0, 0].map(() => Number.POSITIVE_INFINITY);
  const high = [0, 0, 0].map(() => Number.NEGATIVE_INFINITY);
  for (let i = 0; i < pieceCount; i++) {
    for (let k = 0; k < 3; k++) {
      const value = data[4 * i + k]!;
      if (value < low[k]!) low[k] = value;
      if (value > high[k]!) high[k] = value;
    }
  }
  return { low, high };
}

type Rgb = readonly [number, number, number];

/** Writes a layer as RGBA bytes, a texel each; texels without a piece are clear. */
export function paintColours(layer: TextureLayer, pieceCount: number, out: Uint8ClampedArray): void {
  const { low, high } = reach(layer, pieceCount);
  out.fill(0);
  for (let i = 0; i < pieceCount; i++) {
    for (let k = 0; k < 3; k++) {
      const size = high[k]! - low[k]!;
      out[4 * i + k] = size > 0 ? (255 * (layer.data[4 * i + k]! - low[k]!)) / size : 128;
    }
    out[4 * i + 3] = 255;
  }
}

/** Writes amounts as RGBA bytes, from `none` for 0 to `full` for `most`. */
export function paintAmounts(values: Float32Array, most: number, none: Rgb, full: Rgb, out: Uint8ClampedArray): void {
  out.fill(0);
  for (let i = 0; i < values.length; i++) {
    // The root spreads what is small: most pieces move a little, few move much.
    const f = most > 0 ? Math.sqrt(Math.min(1, values[i]! / most)) : 0;
    for (let k = 0; k < 3; k++) out[4 * i + k] = none[k]! + (full[k]! - none[k]!) * f;
    out[4 * i + 3] = 255;
  }
}

/** The four numbers of a piece with their names and units. */
export function texelText(layer: TextureLayer, piece: number): { name: string; value: string; unit: string }[] {
  const { names, units } = wordsOf(layer.id);
  return names.map((name, k) => ({ name, value: layer.data[4 * piece + k]!.toPrecision(5), unit: units[k]! }));
}

/** The piece of a texel, or null where there is none. */
export const pieceAt = ({ width, height, pieceCount }: TextureImages, x: number, y: number): number | null => {
  if (x < 0 || y < 0 || x >= width || y >= height) return null;
  const piece = Math.floor(y) * width + Math.floor(x);
  return piece < pieceCount ? piece : null;
};
