/** So many things at once, so many times a second. */
export interface Rate {
  readonly size: number;
  readonly perSecond: number;
}

/** Skjermo 2006, section 4 and figure 14: vertices of drawn branches, frames a second, on a GeForce 6800 GT. */
export const PAPER_FRAMES: readonly [Rate, Rate] = [
  { size: 165_000, perSecond: 30 },
  { size: 335_000, perSecond: 15 },
];

/** Skjermo 2007, section 5: branches in the textures, steps of the wind a second, on a GeForce 7900 GTX. */
export const PAPER_STEPS: readonly [Rate, Rate] = [
  { size: 256 * 256, perSecond: 600 },
  { size: 512 * 512, perSecond: 180 },
];

/** A server of two processor cores without a graphics card (SwiftShader), by this page's own measuring in November 2026. */
export const CPU_FRAMES: readonly Rate[] = [
  { size: 10_000, perSecond: 56.1 },
  { size: 20_000, perSecond: 24.9 },
  { size: 41_000, perSecond: 14.2 },
  { size: 82_000, perSecond: 5.87 },
  { size: 165_000, perSecond: 3.97 },
  { size: 335_000, perSecond: 1.75 },
];
export const CPU_STEPS: readonly Rate[] = [
  { size: 4096, perSecond: 736 },
  { size: 16_384, perSecond: 245 },
  { size: 65_536, perSecond: 59.8 },
  { size: 262_144, perSecond: 17 },
];

/** What two figures tell: milliseconds before the first thing, and nanoseconds for each. */
export interface Cost {
  readonly start: number;
  readonly each: number;
}

/** The straight line through two rates, as times: time = start + each x size. */
export function costOf([a, b]: readonly [Rate, Rate]): Cost {
  const [ta, tb] = [1000 / a.perSecond, 1000 / b.perSecond];
  const each = (tb - ta) / (b.size - a.size);
  return { start: ta - each * a.size, each: each * 1e6 };
}

/** How often a second a machine of that cost does a size. */
export const rateAt = ({ start, each }: Cost, size: number): number => 1000 / (start + each * 1e-6 * size);

/** The line that lies nearest to several measurements, each weighed by its own time, so that small ones count as much as large ones. */
export function costThrough(rates: readonly Rate[]): Cost | null {
  if (rates.length < 2) return null;
  let [s, x, y, xx, xy] = [0, 0, 0, 0, 0];
  for (const { size, perSecond } of rates) {
    const time = 1000 / perSecond;
    const w = 1 / (time * time);
    s += w;
    x += w * size;
    y += w * time;
    xx += w * size * size;
    xy += w * size * time;
  }
  const each = (s * xy - x * y) / (s * xx - x * x);
  return { start: (y - each * x) / s, each: each * 1e6 };
}
