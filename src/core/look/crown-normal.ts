/** Writes the normal of the crown's ellipsoid through a point to `out`. */
export function crownNormal(crown: ArrayLike<number>, x: number, y: number, z: number, out: Float64Array): void {
  out[0] = (x - crown[0]!) / (crown[3]! * crown[3]!);
  out[1] = (y - crown[1]!) / (crown[4]! * crown[4]!);
  out[2] = (z - crown[2]!) / (crown[5]! * crown[5]!);
  const n = 1 / Math.max(Math.sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]), 1e-6);
  out[0] *= n;
  out[1] *= n;
  out[2] *= n;
}
