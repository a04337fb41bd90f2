import type { Relief } from './bark-relief.ts';

/** A tile of bark, `size` x `size` texels of four bytes: dark 0..255 | slope around | slope along (128 is flat) | height. */
export interface BarkImage {
  readonly size: number;
  readonly data: Uint8Array<ArrayBuffer>;
}

/**
 * A relief as an image.
 *
 * Slopes are those of a relief one tile wide and a fifteenth of a tile deep; the shader scales them.
 */
export function reliefImage({ height, dark }: Relief, size: number): BarkImage {
  const data = new Uint8Array(size * size * 4);
  const mask = size - 1;
  const depth = size / 15 / 2; // central difference over two texels, in texels of height
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const i = y * size + x;
      const sx = (height[y * size + ((x + 1) & mask)]! - height[y * size + ((x - 1) & mask)]!) * depth;
      const sy = (height[((y + 1) & mask) * size + x]! - height[((y - 1) & mask) * size + x]!) * depth;
      data[i * 4] = Math.round(255 * Math.min(1, Math.max(0, dark[i]!)));
      // Slopes to -1..1 by s / (1 + |s|), so that steep walls keep their direction in eight bits.
      data[i * 4 + 1] = Math.round(127.5 + 127.5 * (sx / (1 + Math.abs(sx))));
      data[i * 4 + 2] = Math.round(127.5 + 127.5 * (sy / (1 + Math.abs(sy))));
      data[i * 4 + 3] = Math.round(255 * Math.min(1, Math.max(0, height[i]!)));
    }
  }
  return { size, data };
}
