import { hashPcg, hashUnit } from '../math/hash.ts';
import { cloud, noise, paint, type Relief, smoothstep } from './bark-relief.ts';

/** Scars of leaf bases in a tile along the stem. */
const RINGS = 6;

/** A grey column ringed by the scars of fallen leaves, each a lip over a dark line, with fine cracks along it between them. */
export function palm(size: number): Relief {
  const sag = cloud(3, RINGS, 61, 2);
  const nick = cloud(26, RINGS * 3, 62, 2);
  const clouds = cloud(4, 4, 63, 3);
  const crack = noise(52, 5, 64);
  const lull = noise(7, 8, 65);
  const fine = cloud(80, 40, 66, 2);
  return paint(size, (u, v, out) => {
    const n = nick(u, v);
    const bent = v * RINGS + 0.3 * sag(u, v) + 0.06 * n;
    const ring = Math.floor(bent);
    const own = hashUnit(hashPcg((((ring % RINGS) + RINGS) % RINGS) + 640));
    // A leaf clasps half the stem and more: two arcs to a ring, that meet in a point on one side and then on the other.
    const turn = u * 2 + own;
    const arc = Math.abs(turn - Math.floor(turn) - 0.5) * 2;
    const place = bent - ring - 0.16 * arc * arc;
    const t = place - Math.floor(place);
    const line = smoothstep(0.055, 0.012, Math.min(t, 1 - t) + 0.012 * n);
    const lip = smoothstep(0.32, 0.05, t) * (1 - line);
    const hollow = smoothstep(0.6, 0.97, t);
    const c = clouds(u, v);
    const f = fine(u, v);
    const cracked =
      smoothstep(0.7, 1, 1 - Math.min(1, Math.abs(crack(u + 0.004 * n, v)) * 8)) * smoothstep(0, 0.4, lull(u, v));
    out.height = 0.5 + 0.34 * lip - 0.16 * hollow - 0.4 * line - 0.22 * cracked + 0.06 * c + 0.06 * f;
    out.dark =
      0.2 + 0.62 * line + 0.26 * hollow - 0.12 * lip + 0.34 * cracked + 0.24 * c + 0.16 * f + 0.1 * (own - 0.5);
  });
}
