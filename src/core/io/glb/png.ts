import { encode } from 'fast-png';

/** Three bytes a texel as a PNG file: the same bytes in Node and in every browser. */
export const pngOf = (data: Uint8Array, size: number): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(encode({ width: size, height: size, data, channels: 3, depth: 8 }));
