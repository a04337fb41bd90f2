/** Writes the columns of a frame: the unit vectors (x, y, z) and (tx, ty, tz) at right angles to it, and their cross product. */
export function writeColumns(
  out: Float64Array,
  x: number,
  y: number,
  z: number,
  tx: number,
  ty: number,
  tz: number,
): void {
  out[0] = x;
  out[1] = y;
  out[2] = z;
  out[3] = tx;
  out[4] = ty;
  out[5] = tz;
  out[6] = y * tz - z * ty;
  out[7] = z * tx - x * tz;
  out[8] = x * ty - y * tx;
}
