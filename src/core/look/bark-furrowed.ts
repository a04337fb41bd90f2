import { hashPcg, hashUnit } from '../math/hash.ts';
import { cellMap, cloud, mix, noise, paint, type Relief, smoothstep } from './bark-relief.ts';

/** Long corky ridges that part and meet again around lens-shaped furrows, broken across here and there. */
export function furrowed(size: number): Relief {
  const meander = cloud(3, 4, 22, 2);
  const lean = cloud(7, 9, 23, 2);
  const bend = (u: number, v: number) => 0.05 * meander(u, v) + 0.016 * lean(u, v);
  const cells = cellMap(size, [10, 3], 21, (u, v, out) => {
    out.u = bend(u, v);
    out.v = 0.05 * lean(u, v);
  });
  const width = noise(4, 5, 24);
  const rift = noise(24, 6, 25);
  const cross = noise(15, 22, 26);
  const corky = cloud(30, 16, 27, 3);
  const streak = cloud(64, 12, 29, 2);
  const fine = noise(120, 90, 28);
  return paint(size, (u, v, out, t) => {
    const w = bend(u, v);
    const own = hashUnit(hashPcg(cells.cell[t]! + 401));
    const cork = corky(u + w, v);
    const grain = streak(u + w, v);
    const f = fine(u, v);
    // Furrows along the stem are wide, breaks across a ridge are cracks.
    const wide = (0.028 + 0.022 * width(u, v)) * mix(1, 0.3, cells.around[t]!);
    const bank = cells.distance[t]! + 0.006 * cork + 0.003 * grain;
    const ridge = smoothstep(0.1 * wide, wide, bank);
    const thin = 1 - Math.min(1, Math.abs(rift(u + w, v)) * 8);
    const rifted = smoothstep(0.35, 1, thin) * ridge;
    const broken = smoothstep(0.3, 0.46, cross(u + w, v + 0.02 * cork)) * ridge;
    out.height = ridge * (0.74 + 0.14 * own + 0.14 * cork) - 0.22 * rifted - 0.18 * broken + 0.07 * grain + 0.04 * f;
    out.dark =
      0.93 * (1 - smoothstep(0.08 * wide, 0.8 * wide, bank)) +
      0.34 * rifted +
      0.24 * broken +
      0.2 -
      0.22 * (own - 0.4) * ridge +
      0.2 * cork +
      0.2 * grain +
      0.16 * f;
  });
}
