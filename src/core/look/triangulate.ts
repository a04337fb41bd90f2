type Point = readonly [number, number];

const area = (a: Point, b: Point, c: Point): number => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

/** Shape of a triangle with a positive area, 0..1: twice the area by the square of the longest side. */
function roundness(a: Point, b: Point, c: Point): number {
  const side = (p: Point, q: Point): number => (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2;
  return area(a, b, c) / Math.max(side(a, b), side(b, c), side(c, a), 1e-30);
}

const NO_AREA = 1e-9;

/**
 * A simple polygon as triangles: three places of `points` each, `points.length - 2` of them, turning as the polygon does.
 *
 * Always cuts off the roundest ear, so that points in a row (along a midrib) become corners of triangles with an area. For outlines of some
 * dozens of points: the time grows with the cube of their number. Throws RangeError for a polygon that crosses itself.
 */
export function triangulate(points: readonly Point[]): [number, number, number][] {
  let turned = 0;
  for (let i = 1; i + 1 < points.length; i++) turned += area(points[0]!, points[i]!, points[i + 1]!);
  const sign = turned < 0 ? -1 : 1;
  const left = points.map((_, i) => i);
  const out: [number, number, number][] = [];
  while (left.length > 2) {
    let best = -1;
    let roundest = 0;
    for (let k = 0; k < left.length; k++) {
      const [i, j, l] = corner(left, k);
      const [a, b, c] = sign > 0 ? [points[i]!, points[j]!, points[l]!] : [points[l]!, points[j]!, points[i]!];
      if (area(a, b, c) <= NO_AREA) continue;
      const free = left.every((p) => p === i || p === j || p === l || outside(points[p]!, a, b, c));
      const round = free ? roundness(a, b, c) : 0;
      if (round > roundest) [best, roundest] = [k, round];
    }
    if (best < 0) throw new RangeError('triangulate: the polygon crosses itself.');
    out.push(corner(left, best));
    left.splice(best, 1);
  }
  return out;
}

const corner = (left: readonly number[], k: number): [number, number, number] => [
  left[(k + left.length - 1) % left.length]!,
  left[k]!,
  left[(k + 1) % left.length]!,
];

const outside = (p: Point, a: Point, b: Point, c: Point): boolean =>
  area(a, b, p) < -NO_AREA || area(b, c, p) < -NO_AREA || area(c, a, p) < -NO_AREA;
