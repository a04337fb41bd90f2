import { atan2 } from './elementary.ts';
import type { Frame } from './frame.ts';
import { turnAboutHorizontal, turnAboutVertical } from './frame.ts';

/**
 * Turns a leaf at (x, y, any z) of the tree outwards and upwards, towards the light, by the fraction `bend` in 0..1.
 *
 * The normal is the frame's y axis. First about the tree's vertical, by the wrapped angle from the normal's azimuth to the leaf's own; then
 * about the horizontal axis normal x up. A bend of 1 makes the normal vertical. Source: Weber & Penn 1995, 4.9; row 44 of weber-penn.md
 * and erratum E54 of equations.md.
 */
export function leafBend(f: Frame, x: number, y: number, bend: number): void {
  if (bend === 0) return;
  const out = x * x + y * y;
  const flat = f[3] * f[3] + f[4] * f[4];
  if (out > 1e-18 && flat > 1e-18) {
    turnAboutVertical(f, bend * atan2(f[3] * y - f[4] * x, f[3] * x + f[4] * y));
  }
  const horizontal = Math.sqrt(f[3] * f[3] + f[4] * f[4]);
  if (horizontal > 1e-9) {
    turnAboutHorizontal(f, f[4] / horizontal, -f[3] / horizontal, bend * atan2(horizontal, f[5]));
  }
}
