import { hashPcg, hashUnit } from '../math/hash.ts';
import { cloud, noise, paint, type Relief, smoothstep } from './bark-relief.ts';

/** Joints of a cane in a tile. */
const NODES = 2;

/** A glossy cane: at every joint a sheath's scar, a ridge and a band of pale bloom below them; fine lines along it between. */
export function noded(size: number): Relief {
  const line = noise(56, 2, 81);
  const broad = noise(14, 2, 82);
  const clouds = cloud(3, 3, 83, 3);
  const speck = noise(70, 110, 84);
  const bleed = cloud(18, 6, 85, 2);
  return paint(size, (u, v, out) => {
    const a = clouds(u, v);
    const l = line(u, v) + 0.6 * broad(u, v);
    const level = v * NODES + 0.008 * a;
    const node = Math.floor(level + 0.5);
    // Of an internode's length, upwards from the scar.
    const d = level - node;
    const own = hashUnit(hashPcg((((node % NODES) + NODES) % NODES) + 850));
    const scar = smoothstep(0.0075, 0.002, Math.abs(d));
    const groove = smoothstep(0.012, 0.004, Math.abs(d - 0.018));
    const ridge = smoothstep(0.02, 0.004, Math.abs(d - 0.034));
    const swell = smoothstep(0.09, 0.01, Math.abs(d - 0.015));
    const bloom = smoothstep(-0.16 - 0.05 * bleed(u, v), -0.01, d) * (d < 0 ? 1 : 0);
    const aged = smoothstep(0.05, 0.5, a) * 0.5;
    const s = smoothstep(0.3, 0.6, speck(u, v));
    out.height = 0.4 + 0.22 * swell + 0.3 * ridge - 0.24 * groove + 0.34 * scar + 0.045 * l;
    out.dark =
      0.42 +
      0.12 * l +
      0.22 * a +
      0.1 * aged +
      0.16 * s * (1 - bloom) -
      0.5 * bloom +
      0.5 * scar +
      0.34 * groove * (0.7 + 0.3 * own) -
      0.08 * ridge;
  });
}
