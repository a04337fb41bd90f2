import { hashPcg, hashUnit } from '../math/hash.ts';
import { cloud, noise, paint, type Relief, smoothstep } from './bark-relief.ts';
import { cellBorder, scatter } from './tiling-noise.ts';

/** Long thin strips that weave into each other, shredding at their edges into fibres. */
export function stringy(size: number): Relief {
  const [px, py] = [13, 2];
  const strips = scatter(px, py, 51);
  const weave = cloud(2, 2, 52, 3);
  const sway = noise(9, 5, 53);
  const split = noise(34, 3, 54);
  const fibre = cloud(70, 5, 55, 2);
  const hair = noise(150, 14, 56);
  const wide = noise(6, 4, 57);
  const tatter = noise(26, 9, 58);
  const found = { edge: 0, cell: 0, near: 0 };
  return paint(size, (u, v, out) => {
    const w = 0.045 * weave(u, v) + 0.009 * sway(u, v);
    cellBorder(strips, px, py, u + w, v + 0.16 * weave(v, u), found);
    const own = hashUnit(hashPcg(found.cell + 333));
    const fib = fibre(u + w, v);
    const h = hair(u + w, v);
    const gap = 0.16 + 0.22 * (wide(u, v) + 0.3);
    const bank = found.edge + 0.16 * fib;
    const strip = smoothstep(0.02, gap + 0.12, bank);
    const parted = smoothstep(0.55, 1, 1 - Math.min(1, Math.abs(split(u + w, v)) * 5)) * strip;
    // Where a strip has come loose its edge stands out and throws a line of shadow.
    const loose = smoothstep(0.12, 0.4, tatter(u + w, v)) * strip;
    out.height = strip * (0.62 + 0.2 * own + 0.12 * loose) - 0.26 * parted + 0.13 * fib + 0.06 * h;
    out.dark =
      0.9 * (1 - smoothstep(0.02, gap, bank)) +
      0.4 * parted +
      0.18 +
      0.3 * (own - 0.5) * strip +
      0.26 * fib +
      0.16 * h -
      0.1 * loose;
  });
}
