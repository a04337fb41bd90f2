import { TEXEL } from './layout.ts';
import type { TexelArray } from './packed.ts';

/** Narrowest texture; keeps rows long enough to be worth drawing. */
const LEAST_WIDTH = 16;

/** An empty texel array for `count` things: the least power of two that makes it square or wider, then as many rows as needed. */
export function texelArray(count: number, layers: number): TexelArray {
  let width = LEAST_WIDTH;
  while (width * width < count) width *= 2;
  const height = Math.max(1, Math.ceil(count / width));
  return { width, height, layers, data: new Float32Array(layers * width * height * TEXEL) };
}

/** Where the texel of thing 0 in `layer` starts in `data`; thing i is 4 i floats further. */
export const layerStart = ({ width, height }: TexelArray, layer: number): number => layer * width * height * TEXEL;
