import type { GridDetail } from './detail.ts';

/** The grid that a level gets next as it becomes smaller on screen, and the size at which it does. */
export interface NextGrid extends GridDetail {
  /** Radius in pixels. */
  readonly at: number;
}

const same = (a: GridDetail, b: GridDetail): boolean => a.sectors === b.sectors && a.bands === b.bands;

/** Looks for the switch below a radius in pixels; null where none comes within a factor of 16. */
export function nextGrid(radius: number, gridAt: (radius: number) => GridDetail): NextGrid | null {
  const now = gridAt(radius);
  let high = radius;
  let low = radius * 0.8;
  while (same(gridAt(low), now)) {
    high = low;
    low *= 0.8;
    if (low < radius / 16) return null;
  }
  for (let i = 0; i < 14; i++) {
    const middle = 0.5 * (low + high);
    if (same(gridAt(middle), now)) high = middle;
    else low = middle;
  }
  return { ...gridAt(low), at: high };
}

/** Sizes above a switch, as a factor, over which a grid becomes the one after it. */
const BAND = 1.5;

/** How far a grid at `radius` has become the next, 0..1: all of it where the switch comes, so that nothing is seen of it. */
export function morphTo({ at }: NextGrid, radius: number): number {
  const x = Math.min(1, Math.max(0, (BAND - radius / at) / (BAND - 1)));
  return x * x * (3 - 2 * x);
}

/** Distance from the axis of a polygon's side at a turn, where its corners, one of them at 0, are 1 away. */
export function chordRadius(turns: number, sectors: number): number {
  const part = turns * sectors;
  const beside = (part - Math.floor(part + 1e-9) - 0.5) / sectors;
  return Math.min(1, Math.cos(Math.PI / sectors) / Math.cos(2 * Math.PI * beside));
}
