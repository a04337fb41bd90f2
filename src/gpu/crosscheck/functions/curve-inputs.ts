import type { Cubic } from '../../../core/math/bezier.ts';
import { addScaled, cross, distance, length, subtract, unit, type Vec3 } from '../../../core/math/vec3.ts';
import { between, direction, magnitude, near, type Random } from '../random.ts';

/** A curve of a branch's kind: edges of like length, a bend of up to `bend` radians at each joint, anywhere near the origin. */
export function randomCurve(random: Random, bend = 1.9): Cubic {
  const edge = magnitude(random, 0.01, 3);
  const p0 = direction(random).map((x) => 10 * edge * x * random()) as Vec3;
  const d0 = direction(random);
  const d1 = near(random, d0, bend * random());
  const d2 = near(random, d1, bend * random());
  const p1 = addScaled(p0, d0, edge * between(random, 0.5, 1.5));
  const p2 = addScaled(p1, d1, edge * between(random, 0.5, 1.5));
  return { p0, p1, p2, p3: addScaled(p2, d2, edge * between(random, 0.5, 1.5)) };
}

/** Control points of curves with an edge or more without length, straight ones, and one that turns back on itself. */
export const degenerateCurves: readonly Cubic[] = [
  cubic([0, 0, 0], [0, 0, 1], [0, 0, 2], [0, 0, 3]),
  cubic([1, 0, 0], [1, 0, 0], [1, 0, 1], [1, 1, 2]), // no first edge
  cubic([0, 1, 0], [0, 1, 1], [0, 1, 1], [1, 1, 2]), // no middle edge
  cubic([0, 0, 1], [0, 0, 2], [0, 1, 3], [0, 1, 3]), // no last edge
  cubic([0, 0, 0], [0, 0, 0], [0, 0, 0], [1, 0, 0]),
  cubic([0, 0, 0], [1, 0, 0], [1, 0, 0], [1, 0, 0]),
  cubic([2, 2, 2], [2, 2, 2], [2, 2, 2], [2, 2, 2]), // a point
  cubic([0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]), // half a turn
];

/** The control points as four layers of input; `fourth` holds what goes into the last numbers of the layers. */
export const curveInput = ({ p0, p1, p2, p3 }: Cubic, fourth: readonly number[] = []): number[] =>
  [p0, p1, p2, p3].flatMap((p, i) => [...p, fourth[i] ?? 0]);

/** Four layers of a random curve with bends up to `bend`: u, and O near a right angle to the first edge, as pieces have it, or any way. */
export function framedCurve(random: Random, bend: number): number[] {
  const curve = randomCurve(random, bend);
  const l0 = unit(subtract(curve.p1, curve.p0));
  const o = random() < 0.8 ? near(random, unit(cross(l0, direction(random))), 0.5) : near(random, l0, 3);
  return curveInput(curve, [random(), ...o]);
}

/** O from the fourth numbers of the layers of a curve. */
export const orientationOf = (given: readonly number[]): Vec3 => [given[7], given[11], given[15]];

/** The control points from four layers of input. */
export const curveOf = (given: readonly number[], first = 0): Cubic => {
  const point = (i: number) => given.slice(first + 4 * i, first + 4 * i + 3) as Vec3;
  return { p0: point(0), p1: point(1), p2: point(2), p3: point(3) };
};

/** Length of the control polygon in metres, or a tenth of the distance from the origin where that is more: float32 has no finer steps there. */
export const curveSize = (curve: Cubic): number =>
  Math.max(
    distance(curve.p0, curve.p1) + distance(curve.p1, curve.p2) + distance(curve.p2, curve.p3),
    length(curve.p0) / 10,
    1e-3,
  );

function cubic(p0: Vec3, p1: Vec3, p2: Vec3, p3: Vec3): Cubic {
  return { p0, p1, p2, p3 };
}
