import { TEXEL } from './layout.ts';
import type { TexelArray } from './packed.ts';

/** Narrowest texture; keeps rows long enough to be worth drawing. */
const LEAST_WIDTH = 16;

/** An empty array of float texels for `count` things. */
export const texelArray = (count: number, layers: number): TexelArray =>
  shaped(count, layers, (length) => new Float32Array(length));

/** An empty array of integer texels for `count` things. */
export const wordTexels = (count: number, layers: number): TexelArray<Uint32Array> =>
  shaped(count, layers, (length) => new Uint32Array(length));

/** The least power of two that makes the texture square or wider, then as many rows as needed. */
function shaped<Data extends Float32Array | Uint32Array>(
  count: number,
  layers: number,
  make: (length: number) => Data,
): TexelArray<Data> {
  let width = LEAST_WIDTH;
  while (width * width < count) width *= 2;
  const height = Math.max(1, Math.ceil(count / width));
  return { width, height, layers, data: make(layers * width * height * TEXEL) };
}

/** Where the texel of thing 0 in `layer` starts in `data`; thing i is 4 i floats further. */
export const layerStart = ({ width, height }: Pick<TexelArray, 'width' | 'height'>, layer: number): number =>
  layer * width * height * TEXEL;
