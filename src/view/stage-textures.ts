import type { DataTexture } from 'three';
import { gradientField, gradientNoise } from '../core/look/tiling-noise.ts';
import { tileTexture } from './tile-texture.ts';

/** One octave of a tiling pattern: cells across and along, weight. */
type Octave = readonly [number, number, number];

/** A tile of summed noise, 0..1 in each of three channels. */
function noiseTile(size: number, channels: readonly (readonly Octave[])[]): DataTexture {
  const data = new Uint8Array(size * size * 4).fill(255);
  channels.forEach((octaves, channel) => {
    const fields = octaves.map(([px, py], i) => gradientField(px, py, 100 + channel * 10 + i));
    const total = octaves.reduce((sum, [, , weight]) => sum + weight, 0);
    for (let y = 0; y < size; y++) {
      for (let x = 0; x < size; x++) {
        let sum = 0;
        for (let i = 0; i < octaves.length; i++) {
          const [px, py, weight] = octaves[i];
          sum += weight * gradientNoise(fields[i], px, py, x / size, y / size);
        }
        data[(y * size + x) * 4 + channel] = Math.round(255 * Math.min(1, Math.max(0, 0.5 + (sum / total) * 0.95)));
      }
    }
  });
  return tileTexture(data, size);
}

/** Red: blades. Green: tufts. Blue: patches. */
export const grassTexture = (): DataTexture =>
  noiseTile(256, [
    [
      [9, 9, 0.5],
      [40, 40, 0.7],
      [90, 90, 1],
    ],
    [
      [5, 5, 1],
      [23, 23, 0.8],
    ],
    [
      [3, 3, 1],
      [8, 8, 0.5],
    ],
  ]);

/** Red: thin cloud. */
export const cloudTexture = (): DataTexture =>
  noiseTile(256, [
    [
      [3, 2, 1],
      [6, 5, 0.55],
      [13, 11, 0.3],
      [27, 25, 0.16],
      [60, 60, 0.08],
    ],
  ]);
