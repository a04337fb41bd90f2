import {
  ClampToEdgeWrapping,
  DataTexture,
  FloatType,
  LinearFilter,
  LinearMipmapNearestFilter,
  RedFormat,
  RGBAFormat,
} from 'three';
import { type HeightField, heightAt } from '../../core/forest/height-field.ts';

/** What shaders read of a height field. */
export interface TerrainMaps {
  /** Cells a side; heights stand at the corners. */
  readonly cells: number;
  readonly heights: DataTexture;
  readonly normals: DataTexture;
  /** Metres: lowest, highest; and the land far outside, nearly as high as the highest edge: seen from within, it goes on to the skyline. */
  readonly low: number;
  readonly high: number;
  readonly edge: number;
}

/** Heights at the corners of a grid of `cells` x `cells`, and normals with mip levels; both belong to the caller. */
export function terrainMaps(field: HeightField, cells: number): TerrainMaps {
  const side = cells + 1;
  const step = field.size / cells;
  const half = field.size / 2;
  const height = new Float32Array(side * side);
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  let edge = Number.NEGATIVE_INFINITY;
  let mean = 0;
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      const z = heightAt(field, i * step - half, j * step - half);
      height[j * side + i] = z;
      low = Math.min(low, z);
      high = Math.max(high, z);
      if (i > 0 && j > 0 && i < cells && j < cells) continue;
      edge = Math.max(edge, z);
      mean += z / (4 * cells);
    }
  }
  const normal = new Uint8Array(cells * cells * 4);
  const at = (i: number, j: number): number => height[j * side + i] as number;
  for (let j = 0; j < cells; j++) {
    for (let i = 0; i < cells; i++) {
      const gx = (at(i + 1, j) + at(i + 1, j + 1) - at(i, j) - at(i, j + 1)) / (2 * step);
      const gy = (at(i, j + 1) + at(i + 1, j + 1) - at(i, j) - at(i + 1, j)) / (2 * step);
      const length = Math.hypot(gx, gy, 1);
      const t = 4 * (j * cells + i);
      normal[t] = Math.round(127.5 - (127.5 * gx) / length);
      normal[t + 1] = Math.round(127.5 - (127.5 * gy) / length);
      normal[t + 2] = 255;
      normal[t + 3] = 255;
    }
  }
  const heights = new DataTexture(height, side, side, RedFormat, FloatType);
  heights.name = 'terrain heights';
  heights.needsUpdate = true;
  const normals = new DataTexture(normal, cells, cells, RGBAFormat);
  normals.name = 'terrain normals';
  normals.wrapS = ClampToEdgeWrapping;
  normals.wrapT = ClampToEdgeWrapping;
  normals.magFilter = LinearFilter;
  normals.minFilter = LinearMipmapNearestFilter;
  normals.generateMipmaps = true;
  normals.needsUpdate = true;
  return { cells, heights, normals, low, high, edge: 0.8 * edge + 0.2 * mean };
}
