import type { LeafForm, VeinGroup } from './blade.ts';

/** Numbers by which shaders/leaf/veins.glsl knows the groups. */
export const VEIN_GROUPS: readonly VeinGroup[] = ['none', 'pinnate', 'palmate', 'parallel'];

/** Ends of three ribs; those that a form lacks lie on its midrib. */
export const lobeEnds = ({ lobes = [] }: Pick<LeafForm, 'lobes'>): readonly (readonly [number, number])[] =>
  [0, 1, 2].map((i) => lobes[i] ?? [0, 1]);

const fraction = (x: number): number => x - Math.floor(x);

const smoothstep = (a: number, b: number, x: number): number => {
  const t = Math.min(1, Math.max(0, (x - a) / (b - a)));
  return t * t * (3 - 2 * t);
};

/**
 * Veins of a blade at a place, 0..1 each; x: 0 on the midrib, 1 at the widest place, z: 0 at the base, 1 at the tip. As shaders/leaf/veins.glsl
 * has them.
 */
export function veinsAt(form: LeafForm, x: number, z: number): { rib: number; side: number; rise: number } {
  if (form.veins === 'none') return { rib: 0, side: 0, rise: 0.5 };
  let rib = 1 - smoothstep(0.02, 0.07, x);
  if (form.veins === 'parallel') {
    return { rib: 0.7 * rib, side: 0.5 * (1 - smoothstep(0.05, 0.2, Math.abs(fraction(4 * x) - 0.5))), rise: 0.5 };
  }
  for (const [lx, lz] of form.veins === 'palmate' ? lobeEnds(form) : []) {
    const [px, pz, dz] = [0.5 * x, z - 0.03, lz - 0.03];
    const along = (px * lx + pz * dz) / (lx * lx + dz * dz);
    if (along < 0 || along > 1) continue;
    const wide = 0.022 * (1.1 - along);
    const away = Math.sqrt((px - along * lx) ** 2 + (pz - along * dz) ** 2);
    rib = Math.max(rib, 1 - smoothstep(0.3 * wide, wide, away));
  }
  const beside = Math.abs(fraction((z - x * (0.5 - 0.16 * x)) * 8) - 0.5);
  const fade = 1 - smoothstep(0.45, 1, x);
  return { rib, side: (1 - smoothstep(0.02, 0.1, beside)) * fade, rise: 2 * beside };
}
