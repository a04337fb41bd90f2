import { hashPcg, hashUnit } from '../math/hash.ts';
import { cellMap, cloud, mix, noise, paint, type Relief, smoothstep } from './bark-relief.ts';

/** Blocky plates, longer than wide, built up of thin scales, parted by dark cracks of uneven width. */
export function plated(size: number): Relief {
  const warpX = cloud(5, 4, 33, 3);
  const warpY = cloud(5, 5, 34, 3);
  const ragged = cloud(16, 16, 38, 2);
  const plates = cellMap(size, [7, 4], 31, (u, v, out) => {
    out.u = 0.055 * warpX(u, v) + 0.006 * ragged(u, v);
    out.v = 0.07 * warpY(u, v);
  });
  const scales = cellMap(size, [15, 17], 32, (u, v, out) => {
    out.u = 0.05 * warpY(u, v) + 0.022 * ragged(u, v);
    out.v = 0.07 * warpX(u, v) + 0.022 * ragged(v, u);
  });
  const wide = noise(6, 6, 35);
  const fibre = cloud(40, 10, 36, 3);
  const fine = noise(110, 80, 37);
  return paint(size, (u, v, out, t) => {
    const w = 0.055 * warpX(u, v);
    const fib = fibre(u + w, v);
    const f = fine(u, v);
    const own = hashUnit(hashPcg(plates.cell[t]! + 77));
    const layer = hashUnit(hashPcg(scales.cell[t]! + 911));
    // Some cracks gape, others are hardly open.
    const open = smoothstep(-0.4, 0.4, wide(u, v));
    const gap = (0.004 + 0.018 * open) * mix(1, 0.75, plates.around[t]!);
    // The outer scales have fallen from the rims of a plate: its middle stands highest.
    const worn = smoothstep(0.006, 0.05, plates.distance[t]! + 0.022 * (layer - 0.5));
    const bank = plates.distance[t]! + 0.003 * fib + 0.007 * (layer - 0.5);
    const plate = smoothstep(0.1 * gap, gap, bank);
    // A scale lies on its neighbours with a lifted lower edge.
    const lift = smoothstep(0.02, 0.002, scales.distance[t]!) * (layer > 0.45 ? 1 : 0.25) * plate;
    out.height = plate * (0.42 + 0.22 * worn + 0.2 * layer + 0.1 * own + 0.05 * fib) + 0.04 * lift + 0.05 * f;
    out.dark =
      (0.62 + 0.36 * open) * (1 - smoothstep(0.1 * gap, 0.85 * gap, bank)) +
      0.2 * lift * (1 - layer) +
      0.16 +
      0.34 * (0.5 - own) * plate +
      0.36 * (0.5 - layer) * plate +
      0.16 * (1 - worn) * plate +
      0.2 * fib +
      0.16 * f;
  });
}
