import { hashPcg, hashUnit } from '../math/hash.ts';
import { cloud, noise, smoothstep } from './bark-relief.ts';
import { cellBorder, scatter } from './tiling-noise.ts';

/**
 * A tile of what comes over bark at a larger scale than its own pattern, `size` x `size` texels of four bytes: tone (128 is even) | how soon
 * lichen has a crust there | fine tufts | where moss takes hold. `size` is a power of two; the tile is some 0.7 m wide.
 */
export function growthImage(size: number): Uint8Array<ArrayBuffer> {
  const data = new Uint8Array(size * size * 4);
  const tone = cloud(2, 2, 201, 4);
  const bed = cloud(3, 3, 202, 4);
  const tuft = cloud(40, 40, 203, 2);
  const [n, m] = [6, 17];
  const large = scatter(n, n, 204);
  const small = scatter(m, m, 205);
  const warp = noise(14, 14, 206);
  const found = { edge: 0, cell: 0, near: 0 };
  const byte = (x: number) => Math.round(255 * Math.min(1, Math.max(0, x)));
  // Round crusts of many ages: a cell's own random number says how large its crust is.
  const crust = (points: Float32Array, cells: number, u: number, v: number): number => {
    cellBorder(points, cells, cells, u, v, found);
    const own = hashUnit(hashPcg(found.cell + 57 * cells));
    return own * smoothstep(0.72, 0.05, found.near);
  };
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const u = x / size;
      const v = y / size;
      const w = 0.02 * warp(u, v);
      const b = bed(u, v);
      const t = tuft(u, v);
      const i = 4 * (y * size + x);
      data[i] = byte(0.5 + 0.62 * tone(u, v));
      data[i + 1] = byte(
        Math.max(crust(large, n, u + w, v - w), 0.9 * crust(small, m, u - w, v + w)) + 0.16 * b + 0.1 * t,
      );
      data[i + 2] = byte(0.5 + 0.6 * t);
      data[i + 3] = byte(0.5 + 0.66 * b);
    }
  }
  return data;
}
