/** Heights of the ground over a square that is centred on 0, 0. */
export interface HeightField {
  /** Metres of a side. */
  readonly size: number;
  /** Samples of a side, at least 2; the outermost lie on the edges. */
  readonly side: number;
  /** Metres; side x side, x fastest, from -x, -y: row 0 is the south edge. */
  readonly heights: Float32Array;
}

/** Throws RangeError where a field is no ground: with a single NaN in it a whole forest would be nowhere, and nothing would say why. */
export function checkField({ size, side, heights }: HeightField): void {
  if (!(size > 0 && size < Infinity))
    throw new RangeError(`A height field of ${size} m a side: more than 0 is needed.`);
  if (!(side >= 2)) throw new RangeError(`A height field of ${side} samples a side: at least 2 are needed.`);
  if (heights.length !== side * side)
    throw new RangeError(`A height field of ${side} samples a side has ${heights.length} heights, not ${side * side}.`);
  const at = heights.findIndex((height) => !Number.isFinite(height));
  if (at >= 0)
    throw new RangeError(
      `Height ${at % side}, ${Math.floor(at / side)} of a height field is ${heights[at]}, no metres.`,
    );
}

/** Level ground of `size` metres. */
export const levelField = (size: number): HeightField => ({ size, side: 2, heights: new Float32Array(4) });

/** Cubic Hermite between b and c, whose slopes are those of their neighbours (Catmull-Rom). */
const cubic = (a: number, b: number, c: number, d: number, t: number): number =>
  b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));

/** Metres at a place; beyond the edges as at the edge. Smooth: a surface with no creases at the samples. */
export function heightAt(field: HeightField, x: number, y: number): number {
  const { size, side, heights } = field;
  const last = side - 1;
  const u = Math.min(last, Math.max(0, (x / size + 0.5) * last));
  const v = Math.min(last, Math.max(0, (y / size + 0.5) * last));
  const i = Math.min(last - 1, Math.floor(u));
  const j = Math.min(last - 1, Math.floor(v));
  const i0 = Math.max(0, i - 1);
  const i3 = Math.min(last, i + 2);
  const row = (k: number): number => {
    const at = Math.min(last, Math.max(0, k)) * side;
    return cubic(heights[at + i0]!, heights[at + i]!, heights[at + i + 1]!, heights[at + i3]!, u - i);
  };
  return cubic(row(j - 1), row(j), row(j + 1), row(j + 2), v - j);
}

/** Metres over which slopes are taken: half a cell, and at least a quarter of a metre. */
const stride = ({ size, side }: HeightField): number => Math.max(0.25, size / (side - 1) / 2);

function gradient(field: HeightField, x: number, y: number): [number, number] {
  const d = stride(field);
  return [
    (heightAt(field, x + d, y) - heightAt(field, x - d, y)) / (2 * d),
    (heightAt(field, x, y + d) - heightAt(field, x, y - d)) / (2 * d),
  ];
}

/** Steepness of the ground in radians, 0 where it is level. */
export function slopeAt(field: HeightField, x: number, y: number): number {
  const [gx, gy] = gradient(field, x, y);
  return Math.atan(Math.sqrt(gx * gx + gy * gy));
}

/** The unit normal of the ground, z up. */
export function normalAt(field: HeightField, x: number, y: number): [number, number, number] {
  const [gx, gy] = gradient(field, x, y);
  const length = Math.sqrt(gx * gx + gy * gy + 1);
  return [-gx / length, -gy / length, 1 / length];
}
