import { asWide, type BladeOutline, type HalfOutline } from './leaf-outline.ts';

/** Least half width, so that an outline never touches its midrib between base and tip. */
const LEAST = 0.01;

/** Points that the finest grain of a free outline has between base and tip, where the species gives fewer. */
const SMOOTH = 9;

/** The half width at z of a margin, between its points along a smooth curve. */
function halfWidth(margin: readonly number[], z: number): number {
  const last = margin.length - 1;
  const at = z * last;
  const i = Math.min(last - 1, Math.floor(at));
  const t = at - i;
  const [b, c] = [margin[i]!, margin[i + 1]!];
  const [a, d] = [margin[Math.max(0, i - 1)]!, margin[Math.min(last, i + 2)]!];
  const smooth = b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
  return 0.5 * Math.min(1, Math.max(0, smooth));
}

/** The points at some places along the blade, with those of base and tip. */
function sampled(margin: readonly number[], places: readonly number[]): HalfOutline {
  const inner = places.map((z) => [Math.max(LEAST, halfWidth(margin, z)), z] as const);
  const end = (z: 0 | 1): HalfOutline => {
    const x = halfWidth(margin, z);
    const axis = [0, z] as const;
    if (x < LEAST) return [axis];
    return z === 0 ? [axis, [x, z]] : [[x, z], axis];
  };
  return [...end(0), ...inner, ...end(1)];
}

/** The outline that `foliage.margin` of a species describes: half widths, 0..1 of half the width, at even steps from base to tip; two at least. */
export function marginOutline(margin: readonly number[]): BladeOutline {
  const steps = Math.max(SMOOTH, margin.length);
  const near = sampled(
    margin,
    Array.from({ length: steps - 1 }, (_, i) => (i + 1) / steps),
  );
  const widest = near.reduce((best, point) => (point[0] > best[0] ? point : best));
  const [before, after] = [widest[1] * 0.55, widest[1] + (1 - widest[1]) * 0.5];
  const middle = sampled([0, ...margin.slice(1, -1), 0], [Math.max(0.06, before), Math.min(0.94, after)]);
  const far: HalfOutline = [
    [0, 0],
    [0.5, Math.min(0.9, Math.max(0.1, widest[1]))],
    [0, 1],
  ];
  return { name: 'free outline', near, middle: asWide(near, middle), far: asWide(near, far) };
}
